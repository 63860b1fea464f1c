// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @struct  AreaQuadric
 * @brief   the weighted sum of squared distances to planes
 *
 * Coordinates are relative to an origin near the planes, so that floats are precise enough.
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
  /// Add a plane through the origin, with a normal whose length is twice the area of its triangle.
  void Add(const dvec3& normal)
  {
    const double size = length(normal);
    if (size > 0.0)
    {
      const dvec3 weighted = 0.5 * normal;
      const dvec3 unit = normal / size;
      this->Diagonal += vec3(weighted * unit);
      this->Mixed += vec3(weighted.y * unit.z, weighted.z * unit.x, weighted.x * unit.y);
    }
  }
  /// Add another quadric, whose origin is at `offset`.
  void Add(const AreaQuadric& other, const dvec3& offset)
  {
    const dvec3 product = other.Multiply(offset);
    const dvec3 linear(other.Linear);
    this->Diagonal += other.Diagonal;
    this->Mixed += other.Mixed;
    this->Linear += vec3(linear - product);
    this->Constant += static_cast<float>(other.Constant + dot(product - 2.0 * linear, offset));
  }
  double Evaluate(const dvec3& p) const
  {
    return dot(this->Multiply(p) + 2.0 * dvec3(this->Linear), p) + this->Constant;
  }
  double GetArea() const
  {
    return double(this->Diagonal.x) + double(this->Diagonal.y) + double(this->Diagonal.z);
  }

private:
  dvec3 Multiply(const dvec3& p) const
  {
    const dvec3 d(this->Diagonal);
    const dvec3 m(this->Mixed);
    return { d.x * p.x + m.z * p.y + m.y * p.z, m.z * p.x + d.y * p.y + m.x * p.z,
      m.y * p.x + m.x * p.y + d.z * p.z };
  }

  vec3 Diagonal = vec3(0.0f); // xx, yy, zz
  vec3 Mixed = vec3(0.0f);    // yz, zx, xy
  vec3 Linear = vec3(0.0f);
  float Constant = 0.0f;
};
}

#endif
