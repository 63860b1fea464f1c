// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   square noise images with one random number for each grain, about [0, 1]
 *
 * They are as NoiseImage has them, and tile. Private to the module's own sources.
 */
#ifndef GrainNoise_h
#define GrainNoise_h

#include <vector>

namespace relevo
{
/// Independent numbers, uniform in [0, 1).
std::vector<float> MakeUniformNoise(int size, int grainSize, int seed);

/// Normally distributed numbers, with the mean and the standard deviation that the noise image of
/// VTK's surface LIC has in its range; correlated as a Gaussian filter of standard deviation
/// `smoothing`, in grains, makes independent ones.
std::vector<float> MakeGaussianNoise(int size, int grainSize, double smoothing, int seed);
}

#endif
