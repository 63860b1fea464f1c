// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Bisection/FaceMesh.h"

#include "Bisection/AdaptiveTerrain.h"
#include "Bisection/FaceHeights.h"
#include "Heights/TerrainMeshBuilder.h"
#include "Lattice/BlockErrors.h"

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
    std::array<std::array<double, 3>, 3> world;
    const auto getVertex = [&](const std::array<int, 2>& vertex, std::array<double, 3>& position)
    {
      const auto [a, b] = vertex;
      TerrainMeshBuilder::Vertex result{ (face.Apex[0] + a * face.Step1[0] + b * face.Step2[0])
          << shift,
        (face.Apex[1] + a * face.Step1[1] + b * face.Step2[1]) << shift, heights.GetHeight(a, b) };
      if (placement.Globe)
      {
        position = GlobeFaces::GetWorld(face, *terrain.GetVertices()[i], placement, a, b);
        result.World = &position;
        // There is no surface outside of the projection.
        result.Height = std::isnan(position[0]) ? position[0] : result.Height;
      }
      return result;
    };
    for (const auto& [a, b, c] : TerrainFace::GetPattern())
    {
      mesh.AddTriangle(
        { { getVertex(a, world[0]), getVertex(b, world[1]), getVertex(c, world[2]) } });
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
}
