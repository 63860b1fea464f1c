// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   coefficients of 3D image warping to the plane of a relief
 *
 * Private to the modules.
 */
#ifndef WarpCoefficients_h
#define WarpCoefficients_h

#include "Mathematics/RefinementMathematics.h"
#include "RelevoFiltersReliefModule.h" // for export macro

namespace relevo
{
class Relief;

/**
 * The line from the eye through the point (c, r, w) of texel space intersects the plane of the
 * relief at column (c + K1 h) / (1 + K3 h) and row (r + K2 h) / (1 + K3 h), with h = w - Plane. The
 * point is behind the eye if 1 + K3 h is not positive. M. Oliveira, "Relief Texture Mapping",
 * University of North Carolina, 2000.
 */
struct WarpCoefficients
{
  double K1 = 0.0;
  double K2 = 0.0;
  double K3 = 0.0;
  double Plane = 0.0;
  /// False if the eye is in the plane or behind it.
  bool IsUsable = false;

  bool operator==(const WarpCoefficients& other) const
  {
    return this->K1 == other.K1 && this->K2 == other.K2 && this->K3 == other.K3 &&
      this->Plane == other.Plane && this->IsUsable == other.IsUsable;
  }
};

/// `eye` is in world coordinates, see GetEye().
RELEVOFILTERSRELIEF_EXPORT WarpCoefficients GetWarpCoefficients(
  const Relief& relief, const dvec4& eye);
}

#endif
