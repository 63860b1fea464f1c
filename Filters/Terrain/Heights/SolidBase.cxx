// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Heights/SolidBase.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace relevo
{
namespace
{
using SolidTriangle = std::array<vtkIdType, 3>;

std::vector<SolidTriangle> GetTriangles(vtkPolyData* mesh)
{
  std::vector<SolidTriangle> triangles;
  triangles.reserve(static_cast<std::size_t>(mesh->GetPolys()->GetNumberOfCells()));
  const auto iterator = vtk::TakeSmartPointer(mesh->GetPolys()->NewIterator());
  for (iterator->GoToFirstCell(); !iterator->IsDoneWithTraversal(); iterator->GoToNextCell())
  {
    vtkIdType size;
    const vtkIdType* ids;
    iterator->GetCurrentCell(size, ids);
    triangles.push_back({ { ids[0], ids[1], ids[2] } });
  }
  return triangles;
}

// The directed edges that no other triangle has in the other direction.
std::vector<std::array<vtkIdType, 2>> FindBorder(const std::vector<SolidTriangle>& triangles)
{
  std::vector<std::array<vtkIdType, 2>> edges;
  edges.reserve(3 * triangles.size());
  for (const SolidTriangle& triangle : triangles)
  {
    for (int i = 0; i < 3; ++i)
    {
      edges.push_back({ { triangle[i], triangle[(i + 1) % 3] } });
    }
  }
  std::sort(edges.begin(), edges.end());
  std::vector<std::array<vtkIdType, 2>> border;
  std::copy_if(edges.begin(), edges.end(), std::back_inserter(border),
    [&edges](const std::array<vtkIdType, 2>& edge)
    {
      return !std::binary_search(
        edges.begin(), edges.end(), std::array<vtkIdType, 2>{ { edge[1], edge[0] } });
    });
  return border;
}

// The points where several parts of the mesh touch: more than one edge of the border starts there.
std::vector<vtkIdType> FindTouchingPoints(const std::vector<std::array<vtkIdType, 2>>& border)
{
  std::vector<vtkIdType> points;
  for (std::size_t i = 1; i < border.size(); ++i) // sorted
  {
    if (border[i][0] == border[i - 1][0] && (points.empty() || points.back() != border[i][0]))
    {
      points.push_back(border[i][0]);
    }
  }
  return points;
}

vtkIdType CopyPoint(vtkIdType id, vtkPolyData* mesh)
{
  double position[3];
  mesh->GetPoint(id, position);
  const vtkIdType copy = mesh->GetPoints()->InsertNextPoint(position);
  for (int i = 0; i < mesh->GetPointData()->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* values = mesh->GetPointData()->GetAbstractArray(i);
    values->InsertTuple(copy, id, values);
  }
  return copy;
}

// Triangles around a point that share edges get a point of their own.
void SeparateParts(vtkIdType point, const std::vector<std::size_t>& around,
  std::vector<SolidTriangle>& triangles, vtkPolyData* mesh)
{
  std::vector<std::size_t> rest = around;
  for (bool isFirst = true; !rest.empty(); isFirst = false)
  {
    std::vector<std::size_t> part = { rest.back() };
    rest.pop_back();
    for (std::size_t i = 0; i < part.size(); ++i)
    {
      const SolidTriangle& here = triangles[part[i]];
      const auto isNeighbor = [&](std::size_t other)
      {
        return std::any_of(triangles[other].begin(), triangles[other].end(),
          [&](vtkIdType id)
          { return id != point && std::find(here.begin(), here.end(), id) != here.end(); });
      };
      const auto end = std::partition(
        rest.begin(), rest.end(), [&](std::size_t other) { return !isNeighbor(other); });
      part.insert(part.end(), end, rest.end());
      rest.erase(end, rest.end());
    }
    if (!isFirst)
    {
      const vtkIdType copy = CopyPoint(point, mesh);
      for (std::size_t triangle : part)
      {
        std::replace(triangles[triangle].begin(), triangles[triangle].end(), point, copy);
      }
    }
  }
}

void SeparateTouchingParts(const std::vector<std::array<vtkIdType, 2>>& border,
  std::vector<SolidTriangle>& triangles, vtkPolyData* mesh)
{
  const std::vector<vtkIdType> points = FindTouchingPoints(border);
  std::vector<std::vector<std::size_t>> around(points.size());
  for (std::size_t triangle = 0; triangle < triangles.size() && !points.empty(); ++triangle)
  {
    for (vtkIdType id : triangles[triangle])
    {
      const auto found = std::lower_bound(points.begin(), points.end(), id);
      if (found != points.end() && *found == id)
      {
        around[static_cast<std::size_t>(found - points.begin())].push_back(triangle);
      }
    }
  }
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    SeparateParts(points[i], around[i], triangles, mesh);
  }
}
}

void AddSolidBase(const std::function<std::array<double, 3>(const std::array<double, 3>&)>& toBase,
  double height, vtkPolyData* mesh)
{
  std::vector<SolidTriangle> triangles = GetTriangles(mesh);
  SeparateTouchingParts(FindBorder(triangles), triangles, mesh);
  const vtkIdType below = mesh->GetNumberOfPoints(); // added to an id
  vtkDataArray* heights = mesh->GetPointData()->GetArray("Height");
  for (vtkIdType id = 0; id < below; ++id)
  {
    const vtkIdType copy = CopyPoint(id, mesh);
    std::array<double, 3> position;
    mesh->GetPoint(copy, position.data());
    mesh->GetPoints()->SetPoint(copy, toBase(position).data());
    heights->SetTuple1(copy, height);
  }
  mesh->GetPoints()->Modified(); // bounds and ranges are cached
  heights->Modified();
  vtkNew<vtkCellArray> cells;
  for (const SolidTriangle& triangle : triangles)
  {
    cells->InsertNextCell({ triangle[0], triangle[1], triangle[2] });
  }
  for (const auto& [first, second] : FindBorder(triangles))
  {
    cells->InsertNextCell({ second, first, first + below });
    cells->InsertNextCell({ second, first + below, second + below });
  }
  for (const SolidTriangle& triangle : triangles)
  {
    cells->InsertNextCell({ triangle[0] + below, triangle[2] + below, triangle[1] + below });
  }
  mesh->SetPolys(cells);
}
}
