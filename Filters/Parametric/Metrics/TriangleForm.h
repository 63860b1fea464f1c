// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   TriangleForm
 * @brief   what a patch is over a triangle of its parameters, as a Bézier triangle of its own
 *
 * A tensor product of degrees p and q has the degree p + q there. Control points are homogeneous:
 * coordinates times weight, and weight.
 *
 * Private to the module's own sources.
 */
#ifndef TriangleForm_h
#define TriangleForm_h

#include "Mathematics/RefinementMathematics.h"
#include "Mesh/PatchArrays.h"

#include <vector> // for members

namespace relevo
{
class TriangleForm
{
public:
  /// Of a patch between three corners (u, v). Coordinates are relative to `origin`.
  TriangleForm(
    const PatchArrays& patches, const Patch& patch, const dvec2 corners[3], const dvec3& origin);

  /// Of another form between three of its points, by their barycentric coordinates.
  TriangleForm(const TriangleForm& form, const dvec3 corners[3]);

  int GetDegree() const { return this->Degree; }
  /// In the order of GetTriangleIndex(), by the exponents of the second corner and the third.
  const std::vector<dvec4>& GetPoints() const { return this->Points; }

  /// Whether control points have different weights.
  bool IsRational() const;

  /// The control points on the edge opposite to a corner.
  std::vector<dvec4> GetEdge(int corner) const;

private:
  int Degree = 0;
  std::vector<dvec4> Points;
};
}

#endif
