// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   detection of gaps in the surface of a relief
 *
 * Private to the modules.
 */
#ifndef ReliefSides_h
#define ReliefSides_h

#include "RelevoFiltersReliefModule.h" // for export macro

#include <vector>

namespace relevo
{
class Relief;

/// The default of the stretch, in texel widths, beyond which the surface is open.
constexpr double DefaultMaximumStretch = 8.0;

/// Bits for the connections of a texel.
enum ReliefSide : unsigned char
{
  RightSide = 1, ///< the texel in the next column
  UpperSide = 2, ///< the texel in the next row
  Quad = 4       ///< the surface between the texel and the three at its right and above
};

/**
 * Returns the ReliefSide bits of all texels in rows. Two adjacent texels are connected if both are
 * valid and their distance in the world is at most maximumStretch times the width of a texel, at
 * the depth of the nearer one. A quad exists if its four sides are connected.
 */
RELEVOFILTERSRELIEF_EXPORT std::vector<unsigned char> FindReliefSides(
  const Relief& relief, double maximumStretch);
}

#endif
