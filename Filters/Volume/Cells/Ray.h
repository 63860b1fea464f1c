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

/// Where a ray is inside a cell and its scalars change linearly.
struct RayPart
{
  double Begin;
  double End;
  Scalars Front;
  Scalars Back;

  /// Of shares of its length.
  RayPart Cut(double begin, double end) const
  {
    const auto place = [this](double share)
    { return (1.0 - share) * this->Begin + share * this->End; };
    return { place(begin), place(end), Interpolate(this->Front, this->Back, begin),
      Interpolate(this->Front, this->Back, end) };
  }
};
}

#endif
