// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Contact/InsideTest.h"

#include "Exact/ExactPredicates.h"
#include "Mesh/MovedSurface.h"

#include <random>

namespace relevo
{
namespace
{
enum class Crossing
{
  None,
  Proper,
  Unclear // through an edge, or along the triangle
};

// Tests the segment p q. Neither end is in the triangle.
Crossing Cross(const double p[3], const double q[3], const std::array<const double*, 3>& triangle)
{
  const int pSide = Orient3D(triangle[0], triangle[1], triangle[2], p);
  const int qSide = Orient3D(triangle[0], triangle[1], triangle[2], q);
  if (pSide == qSide)
  {
    return pSide == 0 ? Crossing::Unclear : Crossing::None;
  }
  if (pSide == 0 || qSide == 0)
  {
    return Crossing::None;
  }
  bool hasSide[3] = {}; // right of, on and left of the line
  for (int i = 0; i < 3; ++i)
  {
    hasSide[1 + Orient3D(p, q, triangle[i], triangle[(i + 1) % 3])] = true;
  }
  if (hasSide[0] && hasSide[2])
  {
    return Crossing::None;
  }
  return hasSide[1] ? Crossing::Unclear : Crossing::Proper;
}

// Returns the parity of crossings of the segment p q, or -1 if undetermined.
int CountParity(const double p[3], const double q[3], const MovedSurface& surface)
{
  const DoubleBoxTree& tree = surface.GetTree();
  DoubleBox box;
  box.Add(p);
  box.Add(q);
  int parity = 0;
  std::vector<vtkIdType> stack{ 0 };
  while (!stack.empty())
  {
    const vtkIdType index = stack.back();
    stack.pop_back();
    const DoubleBoxTree::Node& node = tree.GetNodes()[index];
    if (!node.Bounds.Intersects(box))
    {
      continue;
    }
    for (vtkIdType i = node.First; i < node.First + node.Count; ++i)
    {
      const vtkIdType triangle = tree.GetItem(i);
      if (tree.GetBox(i).Intersects(box) && surface.HasArea(triangle))
      {
        const Crossing crossing = Cross(p, q, surface.GetPoints(triangle));
        if (crossing == Crossing::Unclear)
        {
          return -1;
        }
        parity ^= crossing == Crossing::Proper;
      }
    }
    if (node.Count == 0)
    {
      stack.push_back(index + 1);
      stack.push_back(node.First);
    }
  }
  return parity;
}
}

bool IsInside(const double point[3], const MovedSurface& surface)
{
  const DoubleBox& bounds = surface.GetTree().GetNodes().front().Bounds;
  DoubleBox place;
  place.Add(point);
  if (!place.Intersects(bounds))
  {
    return false;
  }
  // Rays are nearly parallel to x and end beyond the surface. Another ray is used if one hits an
  // edge.
  std::mt19937 random(1);
  int parity = -1;
  for (int attempt = 0; attempt < 100 && parity < 0; ++attempt)
  {
    double end[3];
    for (int c = 0; c < 3; ++c)
    {
      const double share = static_cast<double>(random()) / static_cast<double>(random.max());
      const double size = bounds.High[c] - bounds.Low[c];
      end[c] = c == 0 ? bounds.High[0] + (1.0 + share) * bounds.GetSumOfLengths()
                      : point[c] + (share - 0.5) * 0.01 * size;
    }
    parity = CountParity(point, end, surface);
  }
  return parity == 1;
}
}
