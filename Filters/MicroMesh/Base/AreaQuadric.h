// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @struct  AreaQuadric
 * @brief   the weighted sum of squared distances to planes
 *
 * Source: M. Garland, P. Heckbert, "Surface Simplification Using Quadric Error Metrics", SIGGRAPH
 * 1997. The weight of a plane is the area of its triangle.
 */
#ifndef AreaQuadric_h
#define AreaQuadric_h

#include "Mathematics/RefinementMathematics.h"

namespace relevo
{
struct AreaQuadric
{
  /// Add the plane of a triangle with a corner and a normal whose length is twice the area.
  void Add(const dvec3& point, const dvec3& normal)
  {
    const double size = length(normal);
    if (size > 0.0)
    {
      const dvec3 unit = normal / size;
      const double area = 0.5 * size;
      const double d = -dot(unit, point);
      for (int i = 0; i < 3; ++i)
      {
        this->Squares[i] += area * unit[i] * unit;
      }
      this->Linear += area * d * unit;
      this->Constant += area * d * d;
      this->Area += area;
    }
  }
  void Add(const AreaQuadric& other)
  {
    for (int i = 0; i < 3; ++i)
    {
      this->Squares[i] += other.Squares[i];
    }
    this->Linear += other.Linear;
    this->Constant += other.Constant;
    this->Area += other.Area;
  }
  double Evaluate(const dvec3& p) const
  {
    const dvec3 product(
      dot(this->Squares[0], p), dot(this->Squares[1], p), dot(this->Squares[2], p));
    return dot(product, p) + 2.0 * dot(this->Linear, p) + this->Constant;
  }

  dvec3 Squares[3] = { dvec3(0.0), dvec3(0.0), dvec3(0.0) };
  dvec3 Linear = dvec3(0.0);
  double Constant = 0.0;
  double Area = 0.0;
};
}

#endif
