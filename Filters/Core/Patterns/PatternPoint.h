// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @struct  PatternPoint
 * @brief   points of a pattern in integers, with exact predicates
 *
 * Lengths, angles and circles are those of the equilateral triangle. The weights of a point are its
 * affine coordinates in this triangle, so that all of them are integers up to a common factor.
 */
#ifndef PatternPoint_h
#define PatternPoint_h

#include <algorithm>
#include <cstdint>
#include <limits>

namespace relevo
{
/// Height of the equilateral triangle with sides of length 1.
constexpr double TriangleHeight = 0.8660254037844386;

/// Coordinates of a triangulation are multiples of 1 / GridScale. This is coarse enough for a
/// 64-bit in-circle determinant, which is at most 3 GridScale^4.
constexpr std::int64_t GridScale = std::int64_t(1) << 14;

/// Inner points are multiples of 2^-12, so that products of two weights are exact in float.
constexpr std::int64_t InnerStep = GridScale >> 12;

/// The weights of P2 and P3: affine coordinates with P1 = (0,0), P2 = (1,0), P3 = (0,1), by default
/// in units of 1 / GridScale.
struct PatternPoint
{
  std::int64_t V = 0;
  std::int64_t W = 0;
};

inline PatternPoint operator-(PatternPoint a, PatternPoint b)
{
  return { a.V - b.V, a.W - b.W };
}

inline std::int64_t Cross(PatternPoint a, PatternPoint b)
{
  return a.V * b.W - a.W * b.V;
}

/// Twice the dot product. The sides P1P2 and P1P3 are 60 degrees apart.
inline std::int64_t TwiceDot(PatternPoint a, PatternPoint b)
{
  return 2 * (a.V * b.V + a.W * b.W) + a.V * b.W + a.W * b.V;
}

inline std::int64_t SquaredLength(PatternPoint a)
{
  return a.V * a.V + a.V * a.W + a.W * a.W;
}

/// The area of a triangle, positive if counter-clockwise. The area of the whole pattern is the
/// square of the scale.
inline std::int64_t Orientation(PatternPoint a, PatternPoint b, PatternPoint c)
{
  return Cross(b - a, c - a);
}

/// Whether d is inside the circle through a, b, c, which are counter-clockwise.
inline bool IsInCircle(PatternPoint a, PatternPoint b, PatternPoint c, PatternPoint d)
{
  const PatternPoint x = a - d;
  const PatternPoint y = b - d;
  const PatternPoint z = c - d;
  return SquaredLength(x) * Cross(y, z) + SquaredLength(y) * Cross(z, x) +
    SquaredLength(z) * Cross(x, y) >
    0;
}

/// sqrt(3) times the cotangent of a triangle's smallest angle: 1 for equilateral triangles,
/// infinity for degenerate ones. The result is one rounded division of exact integers and therefore
/// portable.
inline double Badness(PatternPoint a, PatternPoint b, PatternPoint c)
{
  const std::int64_t area = Orientation(a, b, c);
  if (area <= 0)
  {
    return std::numeric_limits<double>::infinity();
  }
  const std::int64_t dot =
    std::max({ TwiceDot(b - a, c - a), TwiceDot(c - b, a - b), TwiceDot(a - c, b - c) });
  return static_cast<double>(dot) / static_cast<double>(area);
}

/// a / b rounded half up, for a >= 0 and b > 0.
inline std::int64_t DivideRounded(std::int64_t a, std::int64_t b)
{
  return (2 * a + b) / (2 * b);
}
}

#endif
