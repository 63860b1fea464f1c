// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @struct  CommonPoints
 * @brief   points that two triangles have in common, named by the parts that they are in
 *
 * Private to the module's own sources.
 */
#ifndef CommonPoints_h
#define CommonPoints_h

#include <array> // for members

namespace relevo
{
using TrianglePoints = std::array<const double*, 3>;

/// The smallest part of a triangle that a point is in: a corner 0 to 2, an edge 3 to 5 (3 + i goes
/// from corner i to the next), or the interior.
using TrianglePart = signed char;
constexpr TrianglePart Interior = 6;
constexpr TrianglePart Outside = -1;

inline bool IsCorner(TrianglePart part)
{
  return part >= 0 && part < 3;
}
inline bool IsEdge(TrianglePart part)
{
  return part >= 3 && part < Interior;
}

/// A point that is in a part of each of two triangles.
struct CommonPoint
{
  TrianglePart Parts[2];

  bool operator==(const CommonPoint& other) const
  {
    return this->Parts[0] == other.Parts[0] && this->Parts[1] == other.Parts[1];
  }
};

/// The corners of what two triangles have in common: none, 1 of a point, 2 of a segment, or 3 to 6
/// of a polygon that winds as the first triangle does.
struct CommonPoints
{
  std::array<CommonPoint, 6> Points;
  int Count = 0;

  /// Unless it is there.
  void Add(TrianglePart first, TrianglePart second)
  {
    const CommonPoint point{ { first, second } };
    for (int i = 0; i < this->Count; ++i)
    {
      if (this->Points[i] == point)
      {
        return;
      }
    }
    this->Points[this->Count++] = point;
  }
};

/**
 * The part of a triangle that a point is in, by the sides of its edges that the point is on: all 1
 * inside.
 */
TrianglePart FindPart(const std::array<int, 3>& sides);
}

#endif
