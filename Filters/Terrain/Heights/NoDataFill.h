// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   interpolation of missing heights
 *
 * Private to the module.
 */
#ifndef NoDataFill_h
#define NoDataFill_h

namespace relevo
{
/**
 * Interpolates a smooth height for each sample with validity 0 from the valid samples.
 *
 * This is the push-pull pyramid of Gortler et al., "The Lumigraph" (SIGGRAPH 1996), with relaxation
 * on each level towards the membrane (Laplace) interpolant. It takes linear time, does not depend
 * on the number of threads, and stays in the range of the valid samples. At least one sample must
 * be valid.
 */
void FillNoData(int width, int height, float* samples, const unsigned char* validity);
}

#endif
