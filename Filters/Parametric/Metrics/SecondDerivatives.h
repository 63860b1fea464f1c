// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   SecondDerivatives
 * @brief   bounds of the second derivatives of a rational Bézier triangle
 *
 * For S = A / w, the derivative in directions d and e is N_de / w^3 with C_d = A_d w - A w_d and
 * N_de = (C_d)_e w - 2 C_d w_e. N_de and w^3 are Bézier triangles of the same degree, and w^3 has
 * positive control values. |S_de| is therefore at most the largest ratio of control points of N_de
 * to control values of w^3. N_de does not depend on the origin of A, and is linear in d and e.
 *
 * Private to the module.
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

  /// Returns an upper bound of |S_de| on the triangle. The coordinates of a direction add up to 0.
  double Bound(const dvec3& d, const dvec3& e) const;

private:
  void BuildPolynomial(const TriangleForm& form);
  void BuildRational(const TriangleForm& form);

  bool IsBounded = true;
  // Control points of the derivatives: twice by the coordinate of the second corner, by those of
  // second and third corner, and twice by that of the third corner.
  std::vector<dvec3> UU;
  std::vector<dvec3> UV;
  std::vector<dvec3> VV;
};
}

#endif
