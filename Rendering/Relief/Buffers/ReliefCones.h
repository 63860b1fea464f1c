// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   the relaxed cones of a relief
 *
 * There is a cone above each texel. A ray that goes away from the relief's viewer intersects the
 * surface at most once inside a cone, wherever the ray starts.
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

/// Cones are correct up to this number of texels from their axis, and within the tile.
constexpr int ConeRadius = 8;

/// Return, for each texel of the textures, r / (1 + r) scaled to 255, where r is the cone's radius
/// at height 1.
std::vector<unsigned char> MakeReliefCones(const ReliefTiles& tiles);
}

#endif
