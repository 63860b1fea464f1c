// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Curves/IntersectionPoints.h"

#include "Exact/ExactPoints.h"
#include "Mesh/MovedSurface.h"

#include <algorithm>
#include <cstdint>
#include <unordered_map>
#include <utility>

namespace relevo
{
namespace
{
using Key = std::array<vtkIdType, 6>;

struct KeyHash
{
  std::size_t operator()(const Key& key) const
  {
    std::uint64_t hash = 0;
    for (vtkIdType id : key)
    {
      hash = (hash ^ static_cast<std::uint64_t>(id)) * 0x9e3779b97f4a7c15ull;
      hash ^= hash >> 32;
    }
    return static_cast<std::size_t>(hash);
  }
};

struct Segment
{
  const double* From;
  const double* To;
};

Segment GetEdge(const TrianglePoints& points, TrianglePart edge)
{
  return { points[edge - 3], points[(edge - 2) % 3] };
}
}

IntersectionPoints::Part IntersectionPoints::GetPart(
  const MovedSurface& surface, vtkIdType triangle, TrianglePart part) const
{
  const MovedSurface::Triangle& corners = surface.GetCorners(triangle);
  if (IsCorner(part))
  {
    return { corners[part], -1, -1 };
  }
  if (IsEdge(part))
  {
    const auto ends = std::minmax(corners[part - 3], corners[(part - 2) % 3]);
    return { ends.first, ends.second, -1 };
  }
  Part sorted = corners;
  std::sort(sorted.begin(), sorted.end());
  return sorted;
}

IntersectionPoints::IntersectionPoints(
  const MovedSurface& first, const MovedSurface& second, const std::vector<IntersectingPair>& pairs)
  : Surfaces{ &first, &second }
  , Pairs(pairs)
{
  const bool isSelf = &first == &second;
  std::unordered_map<Key, vtkIdType, KeyHash> known;
  this->Firsts.reserve(pairs.size());
  for (std::size_t p = 0; p < pairs.size(); ++p)
  {
    this->Firsts.push_back(this->Ids.size());
    for (int i = 0; i < pairs[p].Common.Count; ++i)
    {
      const auto& parts = pairs[p].Common.Points[i].Parts;
      const Part a = this->GetPart(first, pairs[p].Triangles[0], parts[0]);
      const Part b = this->GetPart(second, pairs[p].Triangles[1], parts[1]);
      Key key{ a[0], a[1], a[2], b[0], b[1], b[2] };
      if (isSelf)
      {
        key = std::min(key, Key{ b[0], b[1], b[2], a[0], a[1], a[2] });
      }
      const auto found = known.emplace(key, this->GetNumberOfPoints());
      if (found.second)
      {
        this->Uses.push_back({ p, i });
      }
      this->Ids.push_back(found.first->second);
    }
  }
}

void IntersectionPoints::Compute(vtkIdType point, double x[3]) const
{
  const Use& use = this->Uses[point];
  const IntersectingPair& pair = this->Pairs[use.Pair];
  const auto& parts = pair.Common.Points[use.Corner].Parts;
  const TrianglePoints a = this->Surfaces[0]->GetPoints(pair.Triangles[0]);
  const TrianglePoints b = this->Surfaces[1]->GetPoints(pair.Triangles[1]);
  if (IsCorner(parts[0]) || IsCorner(parts[1]))
  {
    const double* corner = IsCorner(parts[0]) ? a[parts[0]] : b[parts[1]];
    std::copy(corner, corner + 3, x);
  }
  else if (parts[1] == Interior)
  {
    const Segment edge = GetEdge(a, parts[0]);
    CrossPlane(edge.From, edge.To, b[0], b[1], b[2], x);
  }
  else if (parts[0] == Interior)
  {
    const Segment edge = GetEdge(b, parts[1]);
    CrossPlane(edge.From, edge.To, a[0], a[1], a[2], x);
  }
  else
  {
    const Segment edge = GetEdge(a, parts[0]);
    const Segment other = GetEdge(b, parts[1]);
    CrossLine(edge.From, edge.To, other.From, other.To, x);
  }
}
}
