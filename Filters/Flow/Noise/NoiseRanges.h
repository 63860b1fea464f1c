// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   ranges of the noise settings
 */
#ifndef NoiseRanges_h
#define NoiseRanges_h

namespace relevo
{
constexpr int SmallestNoiseTexture = 2;
constexpr int LargestNoiseTexture = 16384;
constexpr int FewestNoiseLevels = 2;
}

#endif
