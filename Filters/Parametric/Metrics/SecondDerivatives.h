// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   SecondDerivatives
 * @brief   bounds for the second derivatives of a rational Bézier triangle
 *
 * Of S = A / w the derivative in the directions d and e is N_de / w^3 with C_d = A_d w - A w_d and
 * N_de = (C_d)_e w - 2 C_d w_e. N_de and w^3 are Bézier triangles of one degree, and w^3 has
 * positive control values, so that no |S_de| is more than the largest ratio of control points of
 * N_de to control values of w^3. N_de does not depend on the origin of A, and is linear in d and e.
 *
 * Private to the module's own sources.
 */
#ifndef SecondDerivatives_h
#define SecondDerivatives_h

#include "Mathematics/RefinementMathematics.h"

#include <vector> // for members

namespace relevo
{
class TriangleForm;

class SecondDerivatives
{
public:
  explicit SecondDerivatives(const TriangleForm& form);

  /// No less than |S_de| anywhere on the triangle. The coordinates of a direction sum up to 0.
  double Bound(const dvec3& d, const dvec3& e) const;

private:
  void BuildPolynomial(const TriangleForm& form);
  void BuildRational(const TriangleForm& form);

  bool IsBounded = true;
  // Control points: along the second corner's coordinate twice, along that and the third corner's,
  // and along the third corner's twice.
  std::vector<dvec3> UU;
  std::vector<dvec3> UV;
  std::vector<dvec3> VV;
};
}

#endif
