// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Coarse/CoarseNormals.h"

#include "Points/MergedPoints.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkSMPTools.h"

#include <numeric>

namespace relevo
{
namespace
{
// Whether an earlier triangle of the same patch has the same corner.
bool IsRepeated(const std::vector<CoarseTriangle>& triangles, std::size_t index, int corner)
{
  const CoarseTriangle& triangle = triangles[index];
  for (std::size_t i = index; i-- > 0 && triangles[i].Patch == triangle.Patch;)
  {
    for (const dvec2& coordinates : triangles[i].Coordinates)
    {
      if (coordinates == triangle.Coordinates[corner])
      {
        return true;
      }
    }
  }
  return false;
}
}

std::vector<vtkIdType> FindPlaces(const std::vector<CoarsePoint>& points)
{
  vtkNew<vtkPoints> places;
  places->SetDataTypeToDouble();
  places->SetNumberOfPoints(static_cast<vtkIdType>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    places->SetPoint(static_cast<vtkIdType>(i), &points[i].Place.x);
  }
  std::vector<vtkIdType> lowest = ComputeMergedPoints(places);
  if (lowest.empty())
  {
    lowest.resize(points.size());
    std::iota(lowest.begin(), lowest.end(), 0);
  }
  return lowest;
}

void ComputeNormals(
  const std::vector<FacePatch>& patches, const ControlPoints& homogeneous, CoarseMesh& mesh)
{
  const auto number = static_cast<vtkIdType>(mesh.Triangles.size());
  std::vector<std::array<dvec3, 3>> normals(number);
  vtkSMPTools::For(0, number,
    [&](vtkIdType first, vtkIdType end)
    {
      for (vtkIdType i = first; i < end; ++i)
      {
        const CoarseTriangle& triangle = mesh.Triangles[i];
        for (int k = 0; k < 3; ++k)
        {
          normals[i][k] = IsRepeated(mesh.Triangles, i, k)
            ? dvec3(0.0)
            : EvaluateNormal(patches[triangle.Patch], homogeneous, triangle.Coordinates[k]);
        }
      }
    });
  const std::vector<vtkIdType> places = FindPlaces(mesh.Points);
  std::vector<dvec3> sums(mesh.Points.size(), dvec3(0.0));
  std::vector<dvec3> firsts(mesh.Points.size(), dvec3(0.0));
  for (vtkIdType i = 0; i < number; ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      const vtkIdType place = places[mesh.Triangles[i].Points[k]];
      sums[place] += normals[i][k];
      firsts[place] = firsts[place] == dvec3(0.0) ? normals[i][k] : firsts[place];
    }
  }
  mesh.Normals.resize(mesh.Points.size());
  for (std::size_t i = 0; i < mesh.Points.size(); ++i)
  {
    const vtkIdType place = places[i];
    const double size = length(sums[place]);
    // Opposite normals have no mean. Use the first one.
    mesh.Normals[i] = size > 1e-9 ? sums[place] / size : firsts[place];
  }
}
}
