// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   BezierCrossing
 * @brief   intersection of a ray with a Bézier hexahedron, and its inverse
 *
 * Private to the module.
 */
#ifndef BezierCrossing_h
#define BezierCrossing_h

#include "Bezier/BezierHexahedron.h"
#include "Integral/Ray.h"

#include <array>
#include <utility>
#include <vector>

namespace relevo
{
class BezierCrossing
{
public:
  /// The hexahedron must outlive this object.
  explicit BezierCrossing(const BezierHexahedron& shape);

  /// Returns the parts of the ray inside, in order. Parts that are not longer than `shortest` are
  /// omitted.
  std::vector<std::pair<double, double>> FindInside(const Ray& ray, double shortest) const;

  /**
   * Finds the parameters of a point with Newton's method, clamped to the hexahedron. `parameters`
   * has those of a nearby point. Returns false, with the nearest parameters that were found, if the
   * point is outside.
   */
  bool Locate(const dvec3& point, dvec3& parameters) const;

private:
  bool Solve(const dvec3& point, dvec3& parameters) const;
  bool FindAnywhere(const dvec3& point, dvec3& parameters) const;

  const BezierHexahedron& Shape;
  dvec3 Low;
  dvec3 High;
  std::array<dvec3, BezierHexahedron::NumberOfSamples> Samples;
};
}

#endif
