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
};
}

#endif
