// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @struct  CommonPoints
 * @brief   the intersection of two triangles, as parts of both
 *
 * Private to the module.
 */
#ifndef CommonPoints_h
#define CommonPoints_h

#include <array> // for members

namespace relevo
{
using TrianglePoints = std::array<const double*, 3>;

/// The smallest part of a triangle that contains a point: a corner 0 to 2, an edge 3 to 5 (3 + i
/// leads from corner i to the next), or the interior.
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

/// A point in a part of each of two triangles.
struct CommonPoint
{
  TrianglePart Parts[2];

  bool operator==(const CommonPoint& other) const
  {
    return this->Parts[0] == other.Parts[0] && this->Parts[1] == other.Parts[1];
  }
};

/// The corners of the intersection of two triangles: none, 1 for a point, 2 for a segment, or 3 to
/// 6 for a polygon with the orientation of the first triangle.
struct CommonPoints
{
  std::array<CommonPoint, 6> Points;
  int Count = 0;

  /// Adds a point if it is new.
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
 * Returns the part of a triangle that contains a point, given the side of each edge that the point
 * is on: 1 is inside.
 */
TrianglePart FindPart(const std::array<int, 3>& sides);
}

#endif
