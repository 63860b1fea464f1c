// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Bisection/FaceMesh.h"

#include "Bisection/AdaptiveTerrain.h"
#include "Bisection/FaceHeights.h"
#include "Heights/TerrainMeshBuilder.h"
#include "Lattice/BlockErrors.h"

#include <array>

namespace relevo
{
void MakeFaceMesh(const AdaptiveTerrain& terrain, double exaggeration, vtkPolyData* output)
{
  constexpr int finest = BlockErrors::FinestLevel;
  const RasterDescription& contents = terrain.GetLattice().Describe();
  TerrainMeshBuilder mesh(contents, terrain.GetPlacement(exaggeration), -finest);
  for (const TerrainFace& face : terrain.GetFaces())
  {
    const FaceHeights heights(face);
    const auto getVertex = [&](const std::array<int, 2>& vertex)
    {
      const auto [a, b] = vertex;
      const int shift = face.Level - finest;
      return TerrainMeshBuilder::Vertex{ (face.Apex[0] + a * face.Step1[0] + b * face.Step2[0])
          << shift,
        (face.Apex[1] + a * face.Step1[1] + b * face.Step2[1]) << shift, heights.GetHeight(a, b) };
    };
    for (const auto& [a, b, c] : TerrainFace::GetPattern())
    {
      mesh.AddTriangle({ { getVertex(a), getVertex(b), getVertex(c) } });
    }
  }
  mesh.Finish({ { 0.0, contents.Width - 1.0 } }, { { 0.0, contents.Height - 1.0 } }, output);
}
}
