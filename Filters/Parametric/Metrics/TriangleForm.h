// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   TriangleForm
 * @brief   a patch restricted to a triangle of parameters, as a Bézier triangle
 *
 * A tensor product of degrees p and q becomes a triangle of degree p + q. Control points are
 * homogeneous: coordinates times weight, and weight.
 *
 * Private to the module.
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
  /// Restricts a patch to three corners (u, v). Coordinates are relative to `origin`.
  TriangleForm(
    const PatchArrays& patches, const Patch& patch, const dvec2 corners[3], const dvec3& origin);

  /// Restricts another form to three corners in barycentric coordinates.
  TriangleForm(const TriangleForm& form, const dvec3 corners[3]);

  int GetDegree() const { return this->Degree; }
  /// In the order of GetTriangleIndex(), by the exponents of the second and third corner.
  const std::vector<dvec4>& GetPoints() const { return this->Points; }

  /// Whether weights of control points differ.
  bool IsRational() const;

  /// Returns the control points of the edge opposite to a corner.
  std::vector<dvec4> GetEdge(int corner) const;

private:
  int Degree = 0;
  std::vector<dvec4> Points;
};
}

#endif
