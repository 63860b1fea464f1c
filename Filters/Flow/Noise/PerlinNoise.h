// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   square noise images of octaves of gradient noise, in [0, 1]
 *
 * K. Perlin, "Improving Noise", 2002. Image (column, row) is element column + size * row. They
 * tile. Private to the module's own sources.
 */
#ifndef PerlinNoise_h
#define PerlinNoise_h

#include <vector>

namespace relevo
{
/// The coarsest octave has a period of about `period` texels; each of the next ones half of that
/// and half the height, down to two texels. The smallest number is 0, the largest 1.
std::vector<float> MakePerlinNoise(int size, int period, int seed);
}

#endif
