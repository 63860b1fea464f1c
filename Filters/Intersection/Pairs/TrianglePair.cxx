// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Pairs/TrianglePair.h"

#include "Exact/ExactPredicates.h"
#include "Pairs/CoplanarPair.h"

namespace relevo
{
namespace
{
using Sides = std::array<int, 3>;

Sides GetSides(const TrianglePoints& plane, const TrianglePoints& points)
{
  Sides sides;
  for (int i = 0; i < 3; ++i)
  {
    sides[i] = Orient3D(plane[0], plane[1], plane[2], points[i]);
  }
  return sides;
}

bool AreAllOnOneSide(const Sides& sides)
{
  return sides[0] != 0 && sides[0] == sides[1] && sides[0] == sides[2];
}

// Returns the part of a triangle that the line p q intersects. The line is not in its plane.
TrianglePart FindCrossing(const double p[3], const double q[3], const TrianglePoints& triangle)
{
  Sides sides;
  int sum = 0;
  for (int i = 0; i < 3; ++i)
  {
    sides[i] = Orient3D(p, q, triangle[i], triangle[(i + 1) % 3]);
    sum += sides[i];
  }
  const int inside = sum < 0 ? -1 : 1;
  return FindPart({ inside * sides[0], inside * sides[1], inside * sides[2] });
}

// Calls add(part of the triangle, part of the other) for corners and edges of a triangle that
// intersect the other triangle and are not in its plane. `sides` are the sides of the corners.
template <typename Function>
void MeetBorder(
  const TrianglePoints& triangle, const Sides& sides, const TrianglePoints& other, Function&& add)
{
  for (int i = 0; i < 3; ++i)
  {
    const int next = (i + 1) % 3;
    if (sides[i] == 0)
    {
      add(static_cast<TrianglePart>(i), FindPartInPlane(triangle[i], other));
    }
    else if (sides[i] == -sides[next])
    {
      add(static_cast<TrianglePart>(3 + i), FindCrossing(triangle[i], triangle[next], other));
    }
  }
}
}

CommonPoints IntersectTriangles(const TrianglePoints& a, const TrianglePoints& b)
{
  CommonPoints common;
  const Sides aSides = GetSides(b, a);
  if (AreAllOnOneSide(aSides))
  {
    return common;
  }
  if (aSides == Sides{ 0, 0, 0 })
  {
    return IntersectCoplanarTriangles(a, b);
  }
  const Sides bSides = GetSides(a, b);
  if (AreAllOnOneSide(bSides))
  {
    return common;
  }
  MeetBorder(a, aSides, b,
    [&common](TrianglePart own, TrianglePart other)
    {
      if (other != Outside)
      {
        common.Add(own, other);
      }
    });
  MeetBorder(b, bSides, a,
    [&common](TrianglePart own, TrianglePart other)
    {
      if (other != Outside)
      {
        common.Add(other, own);
      }
    });
  return common;
}
}
