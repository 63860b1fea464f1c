// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Coarse/CoarseMesh.h"

#include "Core/PointPlaces.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkSMPTools.h"
#include "vtkUnstructuredGrid.h"

namespace relevo
{
namespace
{
// Points of the grid that are corners get numbers, in the grid's order.
std::vector<vtkIdType> NumberCorners(
  const ControlNets& nets, vtkUnstructuredGrid* grid, CoarseMesh& mesh)
{
  std::vector<vtkIdType> numbers(grid->GetNumberOfPoints(), -1);
  for (std::size_t i = 0; i < nets.GetPatches().size(); ++i)
  {
    for (int k = 0; k < nets.GetPatches()[i].GetNumberOfCorners(); ++k)
    {
      numbers[nets.GetCornerPoint(i, k)] = 0;
    }
  }
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    if (numbers[i] == 0)
    {
      numbers[i] = static_cast<vtkIdType>(mesh.Points.size());
      CoarsePoint point;
      point.GridPoint = static_cast<vtkIdType>(i);
      grid->GetPoint(point.GridPoint, &point.Place.x);
      mesh.Points.push_back(point);
    }
  }
  return numbers;
}

void AddTriangles(const ControlNets& nets, const std::vector<vtkIdType>& numbers, CoarseMesh& mesh)
{
  for (std::size_t i = 0; i < nets.GetPatches().size(); ++i)
  {
    const FacePatch& patch = nets.GetPatches()[i];
    for (int k = 2; k < patch.GetNumberOfCorners(); ++k)
    {
      CoarseTriangle triangle{ i, {}, {} };
      const std::array<int, 3> corners{ 0, k - 1, k };
      for (int c = 0; c < 3; ++c)
      {
        triangle.Points[c] = numbers[nets.GetCornerPoint(i, corners[c])];
        triangle.Coordinates[c] = patch.GetCorner(corners[c]);
      }
      mesh.Triangles.push_back(triangle);
    }
  }
}

// At each place the mean of the patches' normals there.
void ComputeNormals(const ControlNets& nets, const ControlPoints& controlPoints, CoarseMesh& mesh)
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
          normals[i][k] = EvaluateNormal(
            nets.GetPatches()[triangle.Patch], controlPoints, triangle.Coordinates[k]);
        }
      }
    });
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const CoarsePoint& point : mesh.Points)
  {
    points->InsertNextPoint(&point.Place.x);
  }
  const std::vector<vtkIdType> places = ComputePlaces(points);
  const auto getPlace = [&](vtkIdType point) { return places.empty() ? point : places[point]; };
  std::vector<dvec3> sums(mesh.Points.size(), dvec3(0.0));
  std::vector<dvec3> firsts(mesh.Points.size(), dvec3(0.0));
  for (vtkIdType i = 0; i < number; ++i)
  {
    const CoarseTriangle& triangle = mesh.Triangles[i];
    const bool isSame = i > 0 && mesh.Triangles[i - 1].Patch == triangle.Patch;
    for (int k = 0; k < 3; ++k)
    {
      const dvec2 uv = triangle.Coordinates[k];
      const auto& last = mesh.Triangles[isSame ? i - 1 : i].Coordinates;
      const bool isCounted = isSame && (uv == last[0] || uv == last[1] || uv == last[2]);
      const vtkIdType place = getPlace(triangle.Points[k]);
      sums[place] += isCounted ? dvec3(0.0) : normals[i][k];
      firsts[place] = firsts[place] == dvec3(0.0) ? normals[i][k] : firsts[place];
    }
  }
  mesh.Normals.resize(mesh.Points.size());
  for (std::size_t i = 0; i < mesh.Points.size(); ++i)
  {
    const vtkIdType place = getPlace(static_cast<vtkIdType>(i));
    const double size = length(sums[place]);
    // Patches that face each other have no mean.
    mesh.Normals[i] = size > 1e-9 ? sums[place] / size : firsts[place];
  }
}
}

CoarseMesh BuildCoarseMesh(
  const ControlNets& nets, const ControlPoints& controlPoints, vtkUnstructuredGrid* grid)
{
  CoarseMesh mesh;
  AddTriangles(nets, NumberCorners(nets, grid, mesh), mesh);
  ComputeNormals(nets, controlPoints, mesh);
  return mesh;
}
}
