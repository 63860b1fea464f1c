// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   the two numbers to each axis that 3D image warping onto the relief's plane comes to
 *
 * Private to the modules' own sources.
 */
#ifndef WarpCoefficients_h
#define WarpCoefficients_h

#include "Mathematics/RefinementMathematics.h"
#include "RelevoFiltersReliefModule.h" // for export macro

namespace relevo
{
class Relief;

/**
 * The line from the eye to the point (c, r, w) of texel space meets the relief's plane at column
 * (c + K1 h) / (1 + K3 h) and row (r + K2 h) / (1 + K3 h), with h = w - Plane. Where 1 + K3 h is
 * not more than 0, the point is behind the eye. M. Oliveira, "Relief Texture Mapping", University
 * of North Carolina, 2000.
 */
struct WarpCoefficients
{
  double K1 = 0.0;
  double K2 = 0.0;
  double K3 = 0.0;
  double Plane = 0.0;
  /// False where the eye is in the plane or behind it: no line leads from it to the plane.
  bool IsUsable = false;

  bool operator==(const WarpCoefficients& other) const
  {
    return this->K1 == other.K1 && this->K2 == other.K2 && this->K3 == other.K3 &&
      this->Plane == other.Plane && this->IsUsable == other.IsUsable;
  }
};

/// For an eye in the world, as GetEye() gives it.
RELEVOFILTERSRELIEF_EXPORT WarpCoefficients GetWarpCoefficients(
  const Relief& relief, const dvec4& eye);
}

#endif
