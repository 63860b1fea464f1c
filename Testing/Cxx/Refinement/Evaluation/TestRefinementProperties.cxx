// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves invariants in 100000 random cases of meshes, cameras, metrics and recipes: all refined
// faces of an edge have the same points on it, bit for bit; all points are finite; higher tags
// never give fewer segments; geomorphing does not change the segments; and every failure gives an
// error and an empty output. The small meshes are hostile: random winding, edges with more than two
// faces, degenerate faces, and coincident, collinear and infinite points.
#include "RelevoCheck.h"
#include "RelevoRandomRecipe.h"

#include "vtkAdaptiveRefinement.h"
#include "vtkCellData.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iostream>
#include <map>

using namespace RelevoMeshes;
using namespace RelevoRandomRecipe;

namespace
{
constexpr int NumberOfCases = 100000;

using Chain = std::vector<Point>;
// Points along the edges of a coarse mesh, from the first end to the second. The key is the pair of
// merged points.
using Edges = std::map<std::pair<vtkIdType, vtkIdType>, Chain>;

Point GetPoint(vtkPolyData* mesh, vtkIdType id)
{
  Point point;
  mesh->GetPoint(id, point.data());
  return point;
}

bool IsFinite(const Point& point)
{
  return std::isfinite(point[0]) && std::isfinite(point[1]) && std::isfinite(point[2]);
}

// The lowest id among the points that coincide with each point.
std::vector<vtkIdType> GetPlaces(vtkPolyData* mesh)
{
  std::vector<vtkIdType> places;
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    vtkIdType place = 0;
    while (place < i && GetPoint(mesh, place) != GetPoint(mesh, i))
    {
      ++place;
    }
    places.push_back(place);
  }
  return places;
}

// Maps each point of a face's border to the next one. Empty unless every inner side of its
// triangles is used once in each direction.
std::map<vtkIdType, vtkIdType> GetBorder(const std::vector<Triangle>& triangles)
{
  std::vector<std::pair<vtkIdType, vtkIdType>> sides;
  for (const Triangle& triangle : triangles)
  {
    for (size_t i = 0; i < 3; ++i)
    {
      sides.push_back({ triangle[i], triangle[(i + 1) % 3] });
    }
  }
  std::sort(sides.begin(), sides.end());
  std::map<vtkIdType, vtkIdType> border;
  bool once = std::adjacent_find(sides.begin(), sides.end()) == sides.end();
  for (const auto& [a, b] : sides)
  {
    if (!std::binary_search(sides.begin(), sides.end(), std::make_pair(b, a)))
    {
      once = once && border.emplace(a, b).second;
    }
  }
  return once ? border : std::map<vtkIdType, vtkIdType>();
}

bool IsSame(const Chain& a, const Chain& b)
{
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Point)) == 0;
}

// Finds the edges of the coarse mesh in the refined mesh. Returns an error message.
class EdgeReader
{
public:
  EdgeReader(vtkPolyData* coarse, vtkPolyData* fine)
    : Coarse(coarse)
    , Fine(fine)
    , Places(GetPlaces(coarse))
  {
  }

  std::string Read(Edges& edges)
  {
    std::vector<std::vector<Triangle>> faces(static_cast<size_t>(this->Coarse->GetNumberOfCells()));
    vtkDataArray* cells = this->Fine->GetCellData()->GetArray("vtkOriginalCellIds");
    vtkIdType size;
    const vtkIdType* ids;
    for (vtkIdType t = 0; t < this->Fine->GetNumberOfCells(); ++t)
    {
      this->Fine->GetCellPoints(t, size, ids);
      faces[static_cast<size_t>(cells->GetComponent(t, 0))].push_back({ ids[0], ids[1], ids[2] });
      for (vtkIdType i = 0; i < size; ++i)
      {
        if (!IsFinite(GetPoint(this->Fine, ids[i])))
        {
          return "a point is not finite";
        }
      }
    }
    for (size_t face = 0; face < faces.size(); ++face)
    {
      this->Coarse->GetCellPoints(static_cast<vtkIdType>(face), size, ids);
      const std::string error = this->IsProper(ids)
        ? this->ReadFace(ids, faces[face], edges)
        : std::string(faces[face].empty() ? "" : "a degenerate face was refined");
      if (!error.empty())
      {
        return "face " + std::to_string(face) + ": " + error;
      }
    }
    return {};
  }

private:
  bool IsProper(const vtkIdType* ids)
  {
    const auto& p = this->Places;
    return p[ids[0]] != p[ids[1]] && p[ids[1]] != p[ids[2]] && p[ids[2]] != p[ids[0]] &&
      std::all_of(
        ids, ids + 3, [this](vtkIdType id) { return IsFinite(GetPoint(this->Coarse, id)); });
  }

  std::string ReadFace(
    const vtkIdType* corners, const std::vector<Triangle>& triangles, Edges& edges)
  {
    const std::map<vtkIdType, vtkIdType> border = GetBorder(triangles);
    if (border.empty())
    {
      return "it is missing, or its triangles do not fit together";
    }
    size_t length = 0;
    for (int e = 0; e < 3; ++e)
    {
      const vtkIdType from = corners[e];
      const vtkIdType to = corners[(e + 1) % 3];
      Chain chain;
      if (!this->Follow(border, from, to, chain))
      {
        return "an edge does not lead from corner to corner";
      }
      length += chain.size() - 1;
      std::pair<vtkIdType, vtkIdType> key(this->Places[from], this->Places[to]);
      if (key.first > key.second)
      {
        std::swap(key.first, key.second);
        std::reverse(chain.begin(), chain.end());
      }
      if (!IsSame(chain, edges.emplace(key, chain).first->second))
      {
        return "an edge is not that of another face";
      }
    }
    return length == border.size() ? "" : "its border has more than three edges";
  }

  bool Follow(
    const std::map<vtkIdType, vtkIdType>& border, vtkIdType from, vtkIdType to, Chain& chain)
  {
    vtkIdType here = this->FindCorner(border, from);
    const vtkIdType end = this->FindCorner(border, to);
    if (here < 0 || end < 0)
    {
      return false;
    }
    chain.push_back(GetPoint(this->Fine, here));
    while (here != end && chain.size() <= border.size())
    {
      here = border.at(here);
      chain.push_back(GetPoint(this->Fine, here));
    }
    return here == end;
  }

  // Finds the coarse point on the border, or -1. Coarse points precede points added by refinement,
  // which may coincide with them.
  vtkIdType FindCorner(const std::map<vtkIdType, vtkIdType>& border, vtkIdType coarse)
  {
    vtkDataArray* fineCorners = this->Fine->GetPointData()->GetArray("Corner");
    const double corner = this->Coarse->GetPointData()->GetArray("Corner")->GetComponent(coarse, 0);
    const auto found = std::find_if(border.begin(), border.end(),
      [&](const auto& side) { return fineCorners->GetComponent(side.first, 0) == corner; });
    return found == border.end() ? -1 : found->first;
  }

  vtkPolyData* Coarse;
  vtkPolyData* Fine;
  std::vector<vtkIdType> Places;
};

// Whether every edge has at least as many segments as before, or exactly as many if `same`.
bool AreNoFewer(const Edges& before, const Edges& after, bool same)
{
  return before.size() == after.size() &&
    std::all_of(before.begin(), before.end(),
      [&](const auto& edge)
      {
        const auto found = after.find(edge.first);
        return found != after.end() &&
          (same ? found->second.size() == edge.second.size()
                : found->second.size() >= edge.second.size());
      });
}

std::string CheckSegments(const Edges& edges, vtkAdaptiveRefinement* recipe)
{
  const bool whole = recipe->GetSegmentPolicy() == vtkAdaptiveRefinement::WHOLE_NUMBERS;
  for (const auto& edge : edges)
  {
    const size_t segments = edge.second.size() - 1;
    if (segments > size_t(1) << recipe->GetMaximumLevel() ||
      (!whole && (segments & (segments - 1)) != 0))
    {
      return "an edge has " + std::to_string(segments) + " segments";
    }
  }
  return {};
}

// Applies a change with a known effect to one case. Returns an error message.
std::string CheckChange(Machine& machine, Dice& dice, const Edges& before)
{
  bool same = false;
  switch (dice.Choose(3))
  {
    case 0:
      machine.Recipe->SetLevelOffset(machine.Recipe->GetLevelOffset() + dice.Between(0.0, 1.5));
      break;
    case 1:
      machine.ScreenEdge->SetReferenceLength(
        dice.Between(0.3, 1.0) * machine.ScreenEdge->GetReferenceLength());
      break;
    default:
      machine.Recipe->SetGeomorphing(machine.Recipe->GetGeomorphing() == 0 ? 1 : 0);
      same = true;
      break;
  }
  if (!machine.Run())
  {
    return "it fails after a change";
  }
  Edges after;
  const std::string error = EdgeReader(machine.Input, machine.Filter->GetOutput()).Read(after);
  if (!error.empty())
  {
    return error;
  }
  return AreNoFewer(before, after, same) ? "" : "an edge has other segments than it should";
}
}

int TestRefinementProperties(int, char*[])
{
  RelevoCheck check;
  Machine machine;
  int numberOfFailures = 0;
  vtkIdType numberOfTriangles = 0;
  for (int i = 0; i < NumberOfCases; ++i)
  {
    Dice dice(static_cast<unsigned int>(i));
    machine.Shuffle(dice);
    std::string error;
    vtkPolyData* output = machine.Filter->GetOutput();
    if (machine.Run())
    {
      numberOfTriangles += output->GetNumberOfCells();
      Edges edges;
      error = EdgeReader(machine.Input, output).Read(edges);
      if (error.empty())
      {
        error = CheckSegments(edges, machine.Recipe);
      }
      if (error.empty() && i % 3 == 0)
      {
        error = CheckChange(machine, dice, edges);
      }
    }
    else
    {
      ++numberOfFailures;
      error = output->GetNumberOfPoints() + output->GetNumberOfCells() == 0 ? "" : "output left";
    }
    if (!error.empty())
    {
      check.Fail(__FILE__, __LINE__, "case " + std::to_string(i) + ": " + error);
    }
  }
  std::cout << numberOfTriangles << " triangles; " << numberOfFailures << " cases with errors\n";
  CHECK_GREATER(numberOfTriangles, 10 * NumberOfCases);
  CHECK_GREATER(numberOfFailures, 0);
  CHECK_LESS(numberOfFailures, NumberOfCases / 10);
  return check.GetResult();
}
