// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   for each texel a cone above it in which no ray meets the surface more than once that
 *          goes away from the relief's viewer, wherever it starts
 *
 * F. Policarpo, M. Oliveira, "Relaxed Cone Stepping for Relief Mapping", 2007. Private to the
 * module.
 */
#ifndef ReliefCones_h
#define ReliefCones_h

#include <vector>

namespace relevo
{
class ReliefTiles;

/// Cones are right to this many texels from their axis, and within the tile.
constexpr int ConeRadius = 8;

/// For each texel of the textures r / (1 + r) of 255, where a cone is r wide at height 1.
std::vector<unsigned char> MakeReliefCones(const ReliefTiles& tiles);
}

#endif
