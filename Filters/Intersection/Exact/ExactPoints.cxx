// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Exact/ExactPoints.h"

#include "Exact/ScaledPoints.h"

#include <cmath>
#include <cstdint>

namespace relevo
{
namespace
{
// Returns numerator / denominator * 2^exponent, rounded to nearest.
double RoundQuotient(const BigInteger& numerator, const BigInteger& denominator, int exponent)
{
  if (numerator.is_zero())
  {
    return 0.0;
  }
  BigInteger n = abs(numerator);
  BigInteger d = abs(denominator);
  // The quotient has 64 or 65 bits. The last bit is set if there is a remainder.
  const int shift = 64 - (static_cast<int>(msb(n)) - static_cast<int>(msb(d)));
  if (shift > 0)
  {
    n <<= shift;
  }
  else
  {
    d <<= -shift;
  }
  BigInteger quotient, remainder;
  divide_qr(n, d, quotient, remainder);
  bool hasRest = !remainder.is_zero();
  int lost = 0;
  while (msb(quotient) > 63)
  {
    hasRest = hasRest || bit_test(quotient, 0);
    quotient >>= 1;
    ++lost;
  }
  const auto bits = quotient.convert_to<std::uint64_t>() | static_cast<std::uint64_t>(hasRest);
  const double size = std::ldexp(static_cast<double>(bits), exponent + lost - shift);
  return (numerator.sign() < 0) == (denominator.sign() < 0) ? size : -size;
}

// p and q are on different sides, at the distances `pSide` and `qSide` in any unit.
void Interpolate(
  const ScaledPoints& points, const BigInteger& pSide, const BigInteger& qSide, double x[3])
{
  const BigInteger denominator = pSide - qSide;
  for (int c = 0; c < 3; ++c)
  {
    const BigInteger numerator = pSide * points[1][c] - qSide * points[0][c];
    x[c] = RoundQuotient(numerator, denominator, points.GetExponent());
  }
}
}

void CrossPlane(const double p[3], const double q[3], const double a[3], const double b[3],
  const double c[3], double x[3])
{
  const ScaledPoints points{ p, q, a, b, c };
  const BigPoint ab = Subtract(points[3], points[2]);
  const BigPoint ac = Subtract(points[4], points[2]);
  const BigPoint normal{ Cross(ab, ac, 0), Cross(ab, ac, 1), Cross(ab, ac, 2) };
  const auto getSide = [&](int i)
  {
    const BigPoint ap = Subtract(points[i], points[2]);
    return BigInteger(normal[0] * ap[0] + normal[1] * ap[1] + normal[2] * ap[2]);
  };
  Interpolate(points, getSide(0), getSide(1), x);
}

void CrossLine(
  const double p[3], const double q[3], const double a[3], const double b[3], double x[3])
{
  const ScaledPoints points{ p, q, a, b };
  const BigPoint ab = Subtract(points[3], points[2]);
  // Find an axis in whose projection the lines are not parallel.
  BigInteger pSide, qSide;
  for (int axis = 0; axis < 3 && pSide == qSide; ++axis)
  {
    pSide = Cross(ab, Subtract(points[0], points[2]), axis);
    qSide = Cross(ab, Subtract(points[1], points[2]), axis);
  }
  Interpolate(points, pSide, qSide, x);
}
}
