// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Exact/ExactPredicates.h"

#include "Exact/ScaledPoints.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace relevo
{
namespace
{
constexpr double Rounding = 0.5 * std::numeric_limits<double>::epsilon();
constexpr double Bound3D = (7.0 + 56.0 * Rounding) * Rounding;
constexpr double Bound2D = (3.0 + 16.0 * Rounding) * Rounding;
// Much larger than the error of products that underflow.
constexpr double Underflow = 1e-300;

int GetSign(double value)
{
  return (value > 0.0) - (value < 0.0);
}

bool AreEqual(const double a[3], const double b[3])
{
  return a[0] == b[0] && a[1] == b[1] && a[2] == b[2];
}

int Orient3DExactly(const double a[3], const double b[3], const double c[3], const double d[3])
{
  const ScaledPoints p{ a, b, c, d };
  return Determinant(Subtract(p[1], p[0]), Subtract(p[2], p[0]), Subtract(p[3], p[0])).sign();
}

int Orient2DExactly(const double a[3], const double b[3], const double c[3], int axis)
{
  const ScaledPoints p{ a, b, c };
  return Cross(Subtract(p[1], p[0]), Subtract(p[2], p[0]), axis).sign();
}
}

int Orient3D(const double a[3], const double b[3], const double c[3], const double d[3])
{
  const double ax = a[0] - d[0], ay = a[1] - d[1], az = a[2] - d[2];
  const double bx = b[0] - d[0], by = b[1] - d[1], bz = b[2] - d[2];
  const double cx = c[0] - d[0], cy = c[1] - d[1], cz = c[2] - d[2];
  const double bxcy = bx * cy, cxby = cx * by;
  const double cxay = cx * ay, axcy = ax * cy;
  const double axby = ax * by, bxay = bx * ay;
  const double determinant = az * (bxcy - cxby) + bz * (cxay - axcy) + cz * (axby - bxay);
  const double heights = std::abs(az) + std::abs(bz) + std::abs(cz);
  const double permanent = (std::abs(bxcy) + std::abs(cxby)) * std::abs(az) +
    (std::abs(cxay) + std::abs(axcy)) * std::abs(bz) +
    (std::abs(axby) + std::abs(bxay)) * std::abs(cz);
  // False for infinity and NaN.
  if (std::abs(determinant) > Bound3D * permanent + Underflow * (1.0 + heights))
  {
    return -GetSign(determinant);
  }
  if (AreEqual(a, d) || AreEqual(b, d) || AreEqual(c, d) || AreEqual(a, b) || AreEqual(b, c) ||
    AreEqual(a, c))
  {
    return 0;
  }
  return Orient3DExactly(a, b, c, d);
}

int Orient2D(const double a[3], const double b[3], const double c[3], int axis)
{
  const int u = (axis + 1) % 3;
  const int v = (axis + 2) % 3;
  const double left = (a[u] - c[u]) * (b[v] - c[v]);
  const double right = (a[v] - c[v]) * (b[u] - c[u]);
  const double determinant = left - right;
  if (std::abs(determinant) > Bound2D * (std::abs(left) + std::abs(right)) + Underflow)
  {
    return GetSign(determinant);
  }
  if (AreEqual(a, b) || AreEqual(b, c) || AreEqual(c, a))
  {
    return 0;
  }
  return Orient2DExactly(a, b, c, axis);
}

int FindAxis(const double a[3], const double b[3], const double c[3])
{
  std::array<double, 3> areas;
  for (int axis = 0; axis < 3; ++axis)
  {
    const int u = (axis + 1) % 3;
    const int v = (axis + 2) % 3;
    areas[axis] = std::abs((b[u] - a[u]) * (c[v] - a[v]) - (b[v] - a[v]) * (c[u] - a[u]));
  }
  // Areas may be inaccurate or not finite. They only determine the order of attempts.
  const int guess = static_cast<int>(std::max_element(areas.begin(), areas.end()) - areas.begin());
  for (int i = 0; i < 3; ++i)
  {
    const int axis = (guess + i) % 3;
    if (Orient2D(a, b, c, axis) != 0)
    {
      return axis;
    }
  }
  return -1;
}
}
