// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RelevoWatertight.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkPointData.h"

#include <cmath>
#include <cstring>
#include <set>

namespace RelevoWatertight
{
std::vector<vtkIdType> Weld(vtkPoints* points, bool value)
{
  std::map<std::array<std::uint64_t, 3>, vtkIdType> lowest;
  std::vector<vtkIdType> result;
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    double p[3];
    points->GetPoint(i, p);
    std::array<std::uint64_t, 3> key;
    for (int c = 0; c < 3; ++c)
    {
      const double x = value ? p[c] + 0.0 : p[c];
      std::memcpy(&key[c], &x, sizeof(x));
    }
    result.push_back(lowest.emplace(key, i).first->second);
  }
  return result;
}

void Use(EdgeUses& edges, vtkIdType a, vtkIdType b)
{
  Uses& uses = edges[{ std::min(a, b), std::max(a, b) }];
  ++(a < b ? uses.first : uses.second);
}

std::vector<std::array<vtkIdType, 3>> GetTriangles(
  vtkPolyData* mesh, const std::vector<vtkIdType>& places)
{
  std::vector<std::array<vtkIdType, 3>> triangles;
  auto add = [&](vtkIdType a, vtkIdType b, vtkIdType c)
  {
    if (places[a] != places[b] && places[b] != places[c] && places[a] != places[c])
    {
      triangles.push_back({ { a, b, c } });
    }
  };
  vtkIdType size;
  const vtkIdType* ids;
  auto polys = vtk::TakeSmartPointer(mesh->GetPolys()->NewIterator());
  for (polys->GoToFirstCell(); !polys->IsDoneWithTraversal(); polys->GoToNextCell())
  {
    polys->GetCurrentCell(size, ids);
    for (vtkIdType i = 1; i + 1 < size; ++i)
    {
      add(ids[0], ids[i], ids[i + 1]);
    }
  }
  auto strips = vtk::TakeSmartPointer(mesh->GetStrips()->NewIterator());
  for (strips->GoToFirstCell(); !strips->IsDoneWithTraversal(); strips->GoToNextCell())
  {
    strips->GetCurrentCell(size, ids);
    for (vtkIdType i = 0; i + 2 < size; ++i)
    {
      i % 2 ? add(ids[i + 1], ids[i], ids[i + 2]) : add(ids[i], ids[i + 1], ids[i + 2]);
    }
  }
  return triangles;
}

int GetLevel(const std::vector<double>& tags, vtkIdType a, vtkIdType b, int maximumLevel)
{
  const double mean = tags.empty() ? maximumLevel : std::floor(0.5 * (tags[a] + tags[b]) + 0.5);
  return static_cast<int>(std::min<double>(std::max(mean, 0.0), maximumLevel));
}

std::string FindFault(vtkPolyData* coarse, vtkPolyData* fine, int maximumLevel, bool morphing)
{
  const std::vector<vtkIdType> places = Weld(coarse->GetPoints(), true);
  const std::vector<vtkIdType> welded = Weld(fine->GetPoints(), false);
  const auto coarseTriangles = GetTriangles(coarse, places);

  // Tags of places.
  std::vector<double> tags;
  if (vtkDataArray* array = coarse->GetPointData()->GetArray("DepthTag"))
  {
    tags.assign(places.size(), -1e300);
    for (size_t i = 0; i < places.size(); ++i)
    {
      tags[places[i]] = std::max(tags[places[i]], array->GetComponent(i, 0));
    }
  }

  // Every place is one point of the fine mesh.
  std::map<vtkIdType, vtkIdType> corners; // place to welded fine point
  std::set<vtkIdType> isCorner;
  EdgeUses coarseEdges;
  for (const auto& triangle : coarseTriangles)
  {
    for (int i = 0; i < 3; ++i)
    {
      const vtkIdType place = places[triangle[i]];
      const vtkIdType point = welded[triangle[i]];
      const auto known = corners.emplace(place, point);
      if (known.first->second != point)
      {
        return "points " + std::to_string(place) + " and " + std::to_string(triangle[i]) +
          " lie at one place and come apart";
      }
      isCorner.insert(point);
      Use(coarseEdges, place, places[triangle[(i + 1) % 3]]);
    }
  }
  if (isCorner.size() != corners.size())
  {
    return "two places became one";
  }

  // Edges that are not used once in each direction must be pieces of such coarse edges.
  EdgeUses fineEdges;
  size_t numberOfTriangles = 0;
  vtkIdType size;
  const vtkIdType* ids;
  auto polys = vtk::TakeSmartPointer(fine->GetPolys()->NewIterator());
  for (polys->GoToFirstCell(); !polys->IsDoneWithTraversal(); polys->GoToNextCell())
  {
    polys->GetCurrentCell(size, ids);
    if (size != 3)
    {
      return "a cell that is no triangle";
    }
    const vtkIdType w[3] = { welded[ids[0]], welded[ids[1]], welded[ids[2]] };
    if (w[0] == w[1] || w[1] == w[2] || w[2] == w[0])
    {
      if (morphing)
      {
        continue;
      }
      return "a triangle with two corners at one place";
    }
    ++numberOfTriangles;
    for (int i = 0; i < 3; ++i)
    {
      Use(fineEdges, w[i], w[(i + 1) % 3]);
    }
  }
  const Uses inside(1, 1);
  std::map<vtkIdType, std::vector<vtkIdType>> open;
  size_t numberOfOpen = 0;
  for (const auto& edge : fineEdges)
  {
    if (edge.second != inside)
    {
      open[edge.first.first].push_back(edge.first.second);
      open[edge.first.second].push_back(edge.first.first);
      ++numberOfOpen;
    }
  }
  auto usesFrom = [&fineEdges](vtkIdType a, vtkIdType b)
  {
    const Uses uses = fineEdges[{ std::min(a, b), std::max(a, b) }];
    return a < b ? uses : Uses(uses.second, uses.first);
  };
  for (const auto& edge : coarseEdges)
  {
    if (edge.second == inside)
    {
      continue;
    }
    const vtkIdType from = corners[edge.first.first];
    const vtkIdType to = corners[edge.first.second];
    const int segments = 1 << GetLevel(tags, edge.first.first, edge.first.second, maximumLevel);
    bool found = false;
    for (vtkIdType next : open[from])
    {
      vtkIdType last = from;
      vtkIdType here = next;
      int length = 1;
      bool same = usesFrom(last, here) == edge.second;
      while (same && !isCorner.count(here) && open[here].size() == 2 && length < segments)
      {
        const vtkIdType onward = open[here][open[here][0] == last ? 1 : 0];
        last = here;
        here = onward;
        same = usesFrom(last, here) == edge.second;
        ++length;
      }
      found |= same && here == to && length == segments;
    }
    if (!found)
    {
      return "the open or shared coarse edge " + std::to_string(edge.first.first) + " " +
        std::to_string(edge.first.second) + " is not " + std::to_string(segments) + " fine edges";
    }
    numberOfOpen -= segments;
  }
  if (numberOfOpen != 0)
  {
    return std::to_string(numberOfOpen) + " fine edges that should not be open";
  }

  // Nothing is missing or double: Euler's V - E + F is the same before and after.
  std::set<vtkIdType> used;
  for (const auto& edge : fineEdges)
  {
    used.insert(edge.first.first);
    used.insert(edge.first.second);
  }
  const auto euler = [](size_t v, size_t e, size_t f)
  { return static_cast<long>(v) - static_cast<long>(e) + static_cast<long>(f); };
  const long before = euler(corners.size(), coarseEdges.size(), coarseTriangles.size());
  const long after = euler(used.size(), fineEdges.size(), numberOfTriangles);
  if (before != after)
  {
    return "Euler characteristic " + std::to_string(after) + ", not " + std::to_string(before);
  }
  return "";
}
}
