// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   square noise images with one random number per grain
 *
 * The images have the layout of MakeNoiseImage() and tile. Private to the module.
 */
#ifndef GrainNoise_h
#define GrainNoise_h

#include <vector>

namespace relevo
{
/// Returns independent random numbers, uniform in [0, 1).
std::vector<float> MakeUniformNoise(int size, int grainSize, int seed);

/// Returns normally distributed numbers with the mean and standard deviation of the noise of VTK's
/// surface LIC, relative to its range. Their correlation is that of independent numbers after a
/// Gaussian filter with standard deviation `smoothing`, in grains.
std::vector<float> MakeGaussianNoise(int size, int grainSize, double smoothing, int seed);
}

#endif
