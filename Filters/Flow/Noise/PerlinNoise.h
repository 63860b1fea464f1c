// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   square noise images from octaves of gradient noise, in [0, 1]
 *
 * K. Perlin, "Improving Noise", 2002. Pixel (column, row) is element column + size * row. The
 * images tile. Private to the module.
 */
#ifndef PerlinNoise_h
#define PerlinNoise_h

#include <vector>

namespace relevo
{
/// The coarsest octave has a period of about `period` texels. Each following octave has half the
/// period and half the amplitude, down to two texels. The smallest value is 0, the largest 1.
std::vector<float> MakePerlinNoise(int size, int period, int seed);
}

#endif
