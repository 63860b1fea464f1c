// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Warp/WarpCoefficients.h"

#include "Data/Relief.h"

#include <algorithm>
#include <cmath>

namespace relevo
{
WarpCoefficients GetWarpCoefficients(const Relief& relief, const dvec4& eye)
{
  // Larger shifts, in texels, are parallel to the plane.
  constexpr double farthest = 1e9;

  WarpCoefficients result;
  result.Plane = relief.GetPlane();
  const dvec4 seen = relief.GetWorldToTexel() * (eye.w < 0.0 ? -eye : eye);
  const double distance = seen.z - result.Plane * seen.w;
  result.K1 = -seen.x / distance;
  result.K2 = -seen.y / distance;
  result.K3 = -seen.w / distance;

  const dvec4 middle = relief.GetTexelToWorld() *
    dvec4(0.5 * (relief.GetWidth() - 1), 0.5 * (relief.GetHeight() - 1), result.Plane, 1.0);
  // Heights increase towards the viewer in perspective, and away from the viewer otherwise.
  const bool isPositive = (distance > 0.0) == (middle.w > 0.0);
  const dvec2 range = abs(relief.GetHeightRange() - result.Plane);
  const double largest = std::max(range.x, range.y);
  result.IsUsable = isPositive == relief.IsPerspective() && std::isfinite(result.K3) &&
    std::abs(result.K1) * largest <= farthest && std::abs(result.K2) * largest <= farthest;
  return result;
}
}
