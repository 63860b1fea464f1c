// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   heights where a raster has no data
 *
 * Private to the module's own sources.
 */
#ifndef NoDataFill_h
#define NoDataFill_h

namespace relevo
{
/**
 * Writes a smooth height to every sample whose validity is 0, from the valid ones around.
 *
 * The push-pull pyramid of Gortler et al., "The Lumigraph" (SIGGRAPH 1996), relaxed on every level
 * towards the membrane (Laplace) interpolant: linear time, the same result for any number of
 * threads, and never outside the range of the valid samples. At least one must be valid.
 */
void FillNoData(int width, int height, float* samples, const unsigned char* validity);
}

#endif
