// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Vectors in double precision, with which tests compute expected results.
#ifndef RelevoVector_h
#define RelevoVector_h

#include "vtkMath.h"

#include <array>
#include <cmath>

namespace RelevoVectors
{
using Vector = std::array<double, 3>;

inline Vector operator+(const Vector& a, const Vector& b)
{
  return { { a[0] + b[0], a[1] + b[1], a[2] + b[2] } };
}

inline Vector operator*(double s, const Vector& a)
{
  return { { s * a[0], s * a[1], s * a[2] } };
}

inline Vector operator-(const Vector& a, const Vector& b)
{
  return a + -1.0 * b;
}

inline double dot(const Vector& a, const Vector& b)
{
  return vtkMath::Dot(a.data(), b.data());
}

inline Vector cross(const Vector& a, const Vector& b)
{
  Vector c;
  vtkMath::Cross(a.data(), b.data(), c.data());
  return c;
}

inline double length(const Vector& a)
{
  return std::sqrt(dot(a, a));
}

inline Vector normalize(Vector a)
{
  vtkMath::Normalize(a.data());
  return a;
}

// In degrees.
inline double angle(const Vector& a, const Vector& b)
{
  return vtkMath::DegreesFromRadians(std::atan2(length(cross(a, b)), dot(a, b)));
}
}

#endif
