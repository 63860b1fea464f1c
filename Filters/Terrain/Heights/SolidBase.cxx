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
#include <cstddef>
#include <iterator>
#include <map>
#include <numeric>
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

struct SolidEdge
{
  std::array<vtkIdType, 2> Merged; // points that count as one have the same number
  std::array<vtkIdType, 2> Points;
};

bool IsBefore(const SolidEdge& a, const SolidEdge& b)
{
  return a.Merged < b.Merged;
}

// For each point, the first one at the same position.
std::vector<vtkIdType> MergePoints(bool mergesPoints, vtkPolyData* mesh)
{
  std::vector<vtkIdType> merged(static_cast<std::size_t>(mesh->GetNumberOfPoints()));
  std::iota(merged.begin(), merged.end(), 0);
  if (!mergesPoints)
  {
    return merged;
  }
  const auto getPosition = [mesh](vtkIdType id)
  {
    std::array<double, 3> position;
    mesh->GetPoint(id, position.data());
    return position;
  };
  std::vector<vtkIdType> order = merged;
  std::stable_sort(order.begin(), order.end(),
    [&](vtkIdType a, vtkIdType b) { return getPosition(a) < getPosition(b); });
  for (std::size_t i = 1; i < order.size(); ++i)
  {
    if (getPosition(order[i]) == getPosition(order[i - 1]))
    {
      merged[static_cast<std::size_t>(order[i])] = merged[static_cast<std::size_t>(order[i - 1])];
    }
  }
  return merged;
}

// The directed edges that no other triangle has in the other direction.
std::vector<SolidEdge> FindBorder(
  const std::vector<SolidTriangle>& triangles, const std::vector<vtkIdType>& merged)
{
  std::vector<SolidEdge> edges;
  edges.reserve(3 * triangles.size());
  for (const SolidTriangle& triangle : triangles)
  {
    for (int i = 0; i < 3; ++i)
    {
      const std::array<vtkIdType, 2> ends = { { triangle[i], triangle[(i + 1) % 3] } };
      edges.push_back({ { { merged[static_cast<std::size_t>(ends[0])],
                          merged[static_cast<std::size_t>(ends[1])] } },
        ends });
    }
  }
  std::sort(edges.begin(), edges.end(), IsBefore);
  std::vector<SolidEdge> border;
  std::copy_if(edges.begin(), edges.end(), std::back_inserter(border),
    [&edges](const SolidEdge& edge)
    {
      const SolidEdge reversed = { { { edge.Merged[1], edge.Merged[0] } }, edge.Points };
      return !std::binary_search(edges.begin(), edges.end(), reversed, IsBefore);
    });
  return border;
}

// The points where several parts of the mesh touch: more than one edge of the border starts there.
std::vector<vtkIdType> FindTouchingPoints(const std::vector<SolidEdge>& border)
{
  std::vector<vtkIdType> points;
  for (std::size_t i = 1; i < border.size(); ++i) // sorted
  {
    const vtkIdType point = border[i].Merged[0];
    if (point == border[i - 1].Merged[0] && (points.empty() || points.back() != point))
    {
      points.push_back(point);
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
  std::vector<SolidTriangle>& triangles, std::vector<vtkIdType>& merged, vtkPolyData* mesh)
{
  std::vector<std::size_t> rest = around;
  for (bool isFirst = true; !rest.empty(); isFirst = false)
  {
    std::vector<std::size_t> part = { rest.back() };
    rest.pop_back();
    for (std::size_t i = 0; i < part.size(); ++i)
    {
      const SolidTriangle& here = triangles[part[i]];
      const auto isHere = [&](vtkIdType id)
      {
        const vtkIdType number = merged[static_cast<std::size_t>(id)];
        return number != point &&
          std::any_of(here.begin(), here.end(),
            [&](vtkIdType other) { return merged[static_cast<std::size_t>(other)] == number; });
      };
      const auto isNeighbor = [&](std::size_t other)
      { return std::any_of(triangles[other].begin(), triangles[other].end(), isHere); };
      const auto end = std::partition(
        rest.begin(), rest.end(), [&](std::size_t other) { return !isNeighbor(other); });
      part.insert(part.end(), end, rest.end());
      rest.erase(end, rest.end());
    }
    const vtkIdType number = mesh->GetNumberOfPoints(); // of the copies
    std::map<vtkIdType, vtkIdType> copies;
    for (std::size_t triangle = 0; triangle < part.size() && !isFirst; ++triangle)
    {
      for (vtkIdType& id : triangles[part[triangle]])
      {
        if (merged[static_cast<std::size_t>(id)] == point)
        {
          const auto [copy, isNew] = copies.emplace(id, -1);
          if (isNew)
          {
            copy->second = CopyPoint(id, mesh);
            merged.push_back(number);
          }
          id = copy->second;
        }
      }
    }
  }
}

void SeparateTouchingParts(
  std::vector<SolidTriangle>& triangles, std::vector<vtkIdType>& merged, vtkPolyData* mesh)
{
  const std::vector<vtkIdType> points = FindTouchingPoints(FindBorder(triangles, merged));
  std::vector<std::vector<std::size_t>> around(points.size());
  for (std::size_t triangle = 0; triangle < triangles.size() && !points.empty(); ++triangle)
  {
    for (vtkIdType id : triangles[triangle])
    {
      const vtkIdType number = merged[static_cast<std::size_t>(id)];
      const auto found = std::lower_bound(points.begin(), points.end(), number);
      if (found != points.end() && *found == number)
      {
        around[static_cast<std::size_t>(found - points.begin())].push_back(triangle);
      }
    }
  }
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    SeparateParts(points[i], around[i], triangles, merged, mesh);
  }
}
}

void AddSolidBase(const std::function<std::array<double, 3>(const std::array<double, 3>&)>& toBase,
  double height, bool mergesPoints, vtkPolyData* mesh)
{
  std::vector<SolidTriangle> triangles = GetTriangles(mesh);
  std::vector<vtkIdType> merged = MergePoints(mergesPoints, mesh);
  SeparateTouchingParts(triangles, merged, mesh);
  const vtkIdType below = mesh->GetNumberOfPoints(); // added to an id
  vtkDataArray* heights = mesh->GetPointData()->GetArray("Height");
  for (vtkIdType id = 0; id < below; ++id)
  {
    const vtkIdType copy = CopyPoint(id, mesh);
    std::array<double, 3> position;
    mesh->GetPoint(merged[static_cast<std::size_t>(id)], position.data()); // the same bits
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
  for (const SolidEdge& edge : FindBorder(triangles, merged))
  {
    const auto& [first, second] = edge.Points;
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
