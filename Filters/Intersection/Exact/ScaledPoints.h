// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ScaledPoints
 * @brief   double points as integers of arbitrary length, scaled by a power of two
 *
 * Private to the module.
 */
#ifndef ScaledPoints_h
#define ScaledPoints_h

#include <boost/multiprecision/cpp_int.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <limits>

namespace relevo
{
using BigInteger = boost::multiprecision::cpp_int;
using BigPoint = std::array<BigInteger, 3>;

class ScaledPoints
{
public:
  /// At most 5 points with finite coordinates.
  explicit ScaledPoints(std::initializer_list<const double*> points)
  {
    std::array<Number, 15> numbers;
    int size = 0;
    for (const double* point : points)
    {
      for (int c = 0; c < 3; ++c)
      {
        numbers[size] = Number(point[c]);
        if (numbers[size].Mantissa != 0)
        {
          this->Exponent = std::min(this->Exponent, numbers[size].Exponent);
        }
        ++size;
      }
    }
    for (int i = 0; i < size; ++i)
    {
      BigInteger& coordinate = this->Points[i / 3][i % 3];
      coordinate = numbers[i].Mantissa;
      if (numbers[i].Mantissa != 0)
      {
        coordinate <<= numbers[i].Exponent - this->Exponent;
      }
    }
  }

  const BigPoint& operator[](int point) const { return this->Points[point]; }

  /// Coordinates are the integers times 2 to the power of this exponent.
  int GetExponent() const { return this->Exponent; }

private:
  // Mantissa times 2 to the power of the exponent, with the smallest possible mantissa.
  struct Number
  {
    Number() = default;
    explicit Number(double value)
    {
      int exponent;
      this->Mantissa = static_cast<std::int64_t>(std::ldexp(std::frexp(value, &exponent), 53));
      this->Exponent = exponent - 53;
      while (this->Mantissa != 0 && this->Mantissa % 2 == 0)
      {
        this->Mantissa /= 2;
        ++this->Exponent;
      }
    }

    std::int64_t Mantissa = 0;
    int Exponent = 0;
  };

  std::array<BigPoint, 5> Points;
  int Exponent = std::numeric_limits<int>::max();
};

inline BigPoint Subtract(const BigPoint& a, const BigPoint& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

/// Returns the component of the cross product along an axis.
inline BigInteger Cross(const BigPoint& a, const BigPoint& b, int axis)
{
  const int u = (axis + 1) % 3;
  const int v = (axis + 2) % 3;
  return a[u] * b[v] - a[v] * b[u];
}

inline BigInteger Determinant(const BigPoint& a, const BigPoint& b, const BigPoint& c)
{
  return Cross(a, b, 0) * c[0] + Cross(a, b, 1) * c[1] + Cross(a, b, 2) * c[2];
}
}

#endif
