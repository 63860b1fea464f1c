// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   where the surface of a relief is open
 *
 * Private to the modules' own sources.
 */
#ifndef ReliefSides_h
#define ReliefSides_h

#include "RelevoFiltersReliefModule.h" // for export macro

#include <vector>

namespace relevo
{
class Relief;

/// From how many widths of a texel on the surface is open, unless a setting says otherwise.
constexpr double DefaultMaximumStretch = 8.0;

/// What is joined to a texel, as bits.
enum ReliefSide : unsigned char
{
  RightSide = 1, ///< the texel in the next column
  UpperSide = 2, ///< the texel in the next row
  Quad = 4       ///< the surface between the texel and the three at its right and above
};

/**
 * For each texel its ReliefSide bits, row after row. Two neighbours are joined where both are valid
 * and no farther apart in the world than maximumStretch times the width of a texel: what the two
 * would be apart at the nearer one's depth. A quad is there where its four sides are joined.
 */
RELEVOFILTERSRELIEF_EXPORT std::vector<unsigned char> FindReliefSides(
  const Relief& relief, double maximumStretch);
}

#endif
