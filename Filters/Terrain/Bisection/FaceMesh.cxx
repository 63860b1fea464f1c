// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Bisection/FaceMesh.h"

#include "Bisection/AdaptiveTerrain.h"
#include "Bisection/FaceHeights.h"
#include "Heights/SolidBase.h"
#include "Heights/TerrainMeshBuilder.h"
#include "Lattice/BlockErrors.h"
#include "vtkVariant.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace relevo
{
void MakeFaceMesh(const AdaptiveTerrain& terrain, double exaggeration, vtkPolyData* output)
{
  constexpr int finest = BlockErrors::FinestLevel;
  const RasterDescription& contents = terrain.GetLattice().Describe();
  const TerrainPlacement placement = terrain.GetPlacement(exaggeration);
  TerrainMeshBuilder mesh(contents, placement, -finest);
  for (std::size_t i = 0; i < terrain.GetFaces().size(); ++i)
  {
    const TerrainFace& face = terrain.GetFaces()[i];
    const FaceHeights heights(face);
    const int shift = face.Level - finest;
    // Triangles share vertices.
    std::array<TerrainMeshBuilder::Vertex, GlobeFaces::VerticesPerFace> vertices;
    std::array<std::array<double, 3>, GlobeFaces::VerticesPerFace> world;
    std::array<vtkIdType, GlobeFaces::VerticesPerFace> points;
    points.fill(-1);
    for (int b = 0; b <= TerrainFace::Segments; ++b)
    {
      for (int a = 0; a + b <= TerrainFace::Segments; ++a)
      {
        const int index = GlobeFaces::GetIndex(a, b);
        TerrainMeshBuilder::Vertex& vertex = vertices[index];
        const std::array<std::int64_t, 2> inLattice = face.GetVertex(a, b);
        vertex.Column = inLattice[0] << shift;
        vertex.Row = inLattice[1] << shift;
        vertex.Height = heights.GetHeight(a, b);
        vertex.Point = &points[index];
        if (placement.Globe)
        {
          world[index] = GlobeFaces::GetWorld(face, *terrain.GetVertices()[i], placement, a, b);
          vertex.World = &world[index];
          // There is no surface outside of the projection.
          vertex.Height = std::isnan(world[index][0]) ? world[index][0] : vertex.Height;
        }
      }
    }
    for (const TerrainFace::PatternTriangle& triangle : TerrainFace::GetPattern())
    {
      const auto get = [&](int corner)
      { return vertices[GlobeFaces::GetIndex(triangle[corner][0], triangle[corner][1])]; };
      mesh.AddTriangle({ { get(0), get(1), get(2) } });
    }
  }
  std::array<double, 2> last = { { contents.Width - 1.0, contents.Height - 1.0 } };
  if (const GlobeShape* globe = placement.Globe.get())
  {
    last = globe->GetBorder();
    last[0] = globe->GetPeriod() > 0 ? globe->GetPeriod() : last[0]; // without the overlap
  }
  mesh.Finish({ { 0.0, last[0] } }, { { 0.0, last[1] } }, output);
}

std::string FindBaseError(const AdaptiveTerrain& terrain, double exaggeration, double base)
{
  const GlobeShape* globe = terrain.GetGlobe();
  if (!globe || !globe->GetFrame().GetError().empty())
  {
    return "";
  }
  const GeocentricFrame& frame = globe->GetFrame();
  const double radius =
    frame.GetSemiMajorAxis() * (1.0 - std::max(0.0, frame.GetFlattening())); // the smallest
  const double height = base * terrain.GetPlacement(exaggeration).HeightScale;
  if (height > -radius)
  {
    return "";
  }
  return "BaseHeight is " + vtkVariant(base).ToString() + ", but times the exaggeration of " +
    vtkVariant(exaggeration).ToString() + " it must be above the centre of the globe, at " +
    std::to_string(static_cast<long long>(-radius)) + " m.";
}

void AddBase(const AdaptiveTerrain& terrain, double exaggeration, double base, vtkPolyData* mesh)
{
  const GlobeShape* globe = terrain.GetGlobe();
  const bool isClosed =
    globe && (globe->GetPeriod() > 0 || globe->HasFirstPole() || globe->HasLastPole());
  AddSolidBase([&](const std::array<double, 3>& point)
    { return terrain.ToBase(point, exaggeration, base); },
    base, isClosed, mesh);
}
}
