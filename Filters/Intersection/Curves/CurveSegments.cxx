// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Curves/CurveSegments.h"

#include "Curves/IntersectionPoints.h"

#include <algorithm>
#include <cstdint>
#include <unordered_map>
#include <utility>

namespace relevo
{
namespace
{
using Ends = std::pair<vtkIdType, vtkIdType>;

struct EndsHash
{
  std::size_t operator()(const Ends& ends) const
  {
    const std::uint64_t hash = static_cast<std::uint64_t>(ends.first) * 0x9e3779b97f4a7c15ull +
      static_cast<std::uint64_t>(ends.second);
    return static_cast<std::size_t>(hash ^ (hash >> 32));
  }
};
}

CurveSegments::CurveSegments(
  const std::vector<IntersectingPair>& pairs, const IntersectionPoints& points)
{
  std::vector<unsigned char> areUsed(points.GetNumberOfPoints(), 0);
  // Number of polygons with a side; much larger if the segment has been added.
  constexpr int taken = 1 << 20;
  std::unordered_map<Ends, int, EndsHash> sides;
  for (std::size_t p = 0; p < pairs.size(); ++p)
  {
    const int count = pairs[p].Common.Count;
    if (count >= 3)
    {
      this->Overlaps.push_back(p);
      for (int i = 0; i < count; ++i)
      {
        const vtkIdType point = points.GetId(p, i);
        areUsed[point] = 1;
        ++sides[std::minmax({ point, points.GetId(p, (i + 1) % count) })];
      }
    }
  }
  for (std::size_t p = 0; p < pairs.size(); ++p)
  {
    if (pairs[p].Common.Count == 2)
    {
      const std::array<vtkIdType, 2> ends{ points.GetId(p, 0), points.GetId(p, 1) };
      int& uses = sides[std::minmax({ ends[0], ends[1] })];
      if (uses < 2)
      {
        uses = taken;
        this->Segments.push_back({ ends, p });
        areUsed[ends[0]] = 1;
        areUsed[ends[1]] = 1;
      }
    }
  }
  for (std::size_t p = 0; p < pairs.size(); ++p)
  {
    if (pairs[p].Common.Count == 1 && areUsed[points.GetId(p, 0)] == 0)
    {
      this->Touches.push_back({ points.GetId(p, 0), p });
      areUsed[points.GetId(p, 0)] = 1;
    }
  }
}
}
