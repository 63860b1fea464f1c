// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/MicroNormals.h"

#include "vtkFloatArray.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>

namespace relevo
{
namespace
{
dvec3 GetUnit(const dvec3& v)
{
  const double size = length(v);
  return size > 0.0 ? v / size : dvec3(0.0);
}

// Returns the sum of normals per point of the grid of a face.
std::vector<dvec3> SumNormals(const MicroMesh& mesh, const MicroMesh::Face& face)
{
  const std::vector<dvec3> positions = mesh.GetPositions(face);
  std::vector<dvec3> sums(positions.size(), dvec3(0.0));
  ForEachGridTriangle(1 << face.Level,
    [&](int a, int b, int c)
    {
      const int corners[3] = { a, b, c };
      dvec3 sides[3];
      for (int i = 0; i < 3; ++i)
      {
        sides[i] = GetUnit(positions[static_cast<std::size_t>(corners[(i + 1) % 3])] -
          positions[static_cast<std::size_t>(corners[i])]);
      }
      const dvec3 normal = GetUnit(cross(sides[0], sides[1]));
      for (int i = 0; i < 3; ++i)
      {
        const double cosine = -dot(sides[i], sides[(i + 2) % 3]);
        sums[static_cast<std::size_t>(corners[i])] +=
          std::acos(std::max(-1.0, std::min(1.0, cosine))) * normal;
      }
    });
  return sums;
}
}

std::array<dvec3, 3> ComputeCornerNormals(const MicroMesh& mesh, const MicroMesh::Face& face)
{
  const int n = 1 << face.Level;
  const std::vector<dvec3> sums = SumNormals(mesh, face);
  return { { sums[static_cast<std::size_t>(GetGridIndex(n, { { n, 0, 0 } }))],
    sums[static_cast<std::size_t>(GetGridIndex(n, { { 0, n, 0 } }))],
    sums[static_cast<std::size_t>(GetGridIndex(n, { { 0, 0, n } }))] } };
}

vtkSmartPointer<vtkFloatArray> MakePointNormals(const MicroMesh& mesh)
{
  std::vector<std::array<dvec3, 3>> ofFaces(mesh.Faces.size());
  vtkSMPTools::For(0, static_cast<vtkIdType>(mesh.Faces.size()),
    [&](vtkIdType first, vtkIdType last)
    {
      for (auto f = static_cast<std::size_t>(first); f < static_cast<std::size_t>(last); ++f)
      {
        ofFaces[f] = ComputeCornerNormals(mesh, mesh.Faces[f]);
      }
    });
  std::vector<dvec3> sums(mesh.Points.size(), dvec3(0.0));
  for (std::size_t f = 0; f < mesh.Faces.size(); ++f)
  {
    for (std::size_t c = 0; c < 3; ++c)
    {
      sums[static_cast<std::size_t>(mesh.Faces[f].Corners[c])] += ofFaces[f][c];
    }
  }
  auto normals = vtkSmartPointer<vtkFloatArray>::New();
  normals->SetName(MicroNormalsName);
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(static_cast<vtkIdType>(sums.size()));
  for (std::size_t i = 0; i < sums.size(); ++i)
  {
    const vec3 normal(GetUnit(sums[i]));
    normals->SetTypedTuple(static_cast<vtkIdType>(i), &normal.x);
  }
  return normals;
}

std::vector<vec3> ComputeSampleNormals(const MicroMesh& mesh)
{
  std::vector<dvec3> sums(mesh.Samples.size(), dvec3(0.0));
  for (const MicroMesh::Face& face : mesh.Faces)
  {
    const int n = 1 << face.Level;
    const std::vector<dvec3> ofFace = SumNormals(mesh, face);
    ForEachGridPoint(n,
      [&](const GridPoint& point)
      {
        const bool isCorner = *std::max_element(point.begin(), point.end()) == n;
        const int sample = isCorner ? -1 : mesh.GetSampleIndex(face, point);
        if (sample >= 0)
        {
          sums[static_cast<std::size_t>(sample)] +=
            ofFace[static_cast<std::size_t>(GetGridIndex(n, point))];
        }
      });
  }
  std::vector<vec3> normals;
  normals.reserve(sums.size());
  for (const dvec3& sum : sums)
  {
    normals.emplace_back(GetUnit(sum));
  }
  return normals;
}
}
