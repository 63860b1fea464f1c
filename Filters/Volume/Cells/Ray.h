// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   a ray, and what it meets on its way
 *
 * Private to the module's own sources.
 */
#ifndef Ray_h
#define Ray_h

#include "Integral/TransferFunctions.h"

namespace relevo
{
/// Points Origin + t Direction, t from 0 to Length; Direction has length 1.
struct Ray
{
  dvec3 Origin;
  dvec3 Direction;
  double Length;
};

/// Of each component, by world coordinates.
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

/// Where a ray is inside a cell and its scalars change linearly.
struct RayPart
{
  double Begin;
  double End;
  Scalars Front;
  Scalars Back;
  Scalars Steepness = {}; // lengths of the gradients of the cell itself, if asked for
  //@{
  /// Gradients that are continuous across cells, if asked for.
  Gradients FrontGradients = {};
  Gradients BackGradients = {};
  //@}

  /// Of shares of its length.
  RayPart Cut(double begin, double end) const
  {
    const auto getPosition = [this](double share)
    { return (1.0 - share) * this->Begin + share * this->End; };
    return { getPosition(begin), getPosition(end), Interpolate(this->Front, this->Back, begin),
      Interpolate(this->Front, this->Back, end), this->Steepness,
      Interpolate(this->FrontGradients, this->BackGradients, begin),
      Interpolate(this->FrontGradients, this->BackGradients, end) };
  }
};
}

#endif
