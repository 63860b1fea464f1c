// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   the distance of a point from a segment, in two or three dimensions
 *
 * Private to the module.
 */
#ifndef SegmentDistance_h
#define SegmentDistance_h

#include <algorithm>

namespace relevo
{
/// Returns the square of the distance of a point from the segment from a to b.
template <typename Vector>
double GetSegmentDistance2(const Vector& point, const Vector& a, const Vector& b)
{
  const Vector along = b - a;
  const double squared = dot(along, along);
  const double t =
    squared > 0.0 ? std::max(0.0, std::min(1.0, dot(point - a, along) / squared)) : 0.0;
  const Vector offset = point - (a + t * along);
  return dot(offset, offset);
}
}

#endif
