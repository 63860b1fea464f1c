// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   a ray and its parts inside of cells
 *
 * Private to the module.
 */
#ifndef Ray_h
#define Ray_h

#include "Integral/TransferFunctions.h"

namespace relevo
{
/// The points Origin + t * Direction with t from 0 to Length. Direction is normalized.
struct Ray
{
  dvec3 Origin;
  dvec3 Direction;
  double Length;
};

/// The gradients of all components in world coordinates.
using Gradients = std::array<dvec3, MaximumComponents>;

inline Gradients Interpolate(const Gradients& front, const Gradients& back, double share)
{
  Gradients result;
  for (size_t i = 0; i < result.size(); ++i)
  {
    result[i] = mix(front[i], back[i], share);
  }
  return result;
}

/// A part of a ray inside of a cell, along which the scalars are linear.
struct RayPart
{
  double Begin;
  double End;
  Scalars Front;
  Scalars Back;
  Scalars Steepness = {}; // gradient magnitudes of the cell, if requested
  //@{
  /// Gradients that are continuous across cells, if requested.
  Gradients FrontGradients = {};
  Gradients BackGradients = {};
  //@}
  size_t Cell = 0; // number of the cell, see VolumeCells::GetSource()

  /// Returns the part between two fractions of the length.
  RayPart Cut(double begin, double end) const
  {
    const auto getPosition = [this](double share)
    { return (1.0 - share) * this->Begin + share * this->End; };
    return { getPosition(begin), getPosition(end), Interpolate(this->Front, this->Back, begin),
      Interpolate(this->Front, this->Back, end), this->Steepness,
      Interpolate(this->FrontGradients, this->BackGradients, begin),
      Interpolate(this->FrontGradients, this->BackGradients, end), this->Cell };
  }
};
}

#endif
