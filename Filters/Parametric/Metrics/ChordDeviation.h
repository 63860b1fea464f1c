// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   deviation of a rational Bézier curve from chords of equal parameter intervals
 *
 * For S = A / w, the second derivative is N / w^3 with C = A' w - A w' and N = C' w - 2 C w'. N and
 * w^3 are Bézier curves of the same degree, and w^3 has positive control values. |S''| is therefore
 * at most the largest ratio of control points of N to control values of w^3. N does not depend on
 * the origin of A.
 *
 * Private to the module.
 */
#ifndef ChordDeviation_h
#define ChordDeviation_h

#include "Mathematics/RefinementMathematics.h"

#include <vector> // for points

namespace relevo
{
/// Returns a bound d for a curve of homogeneous points: with n equal segments, the deviation is at
/// most d / n^2.
double ComputeChordDeviation(const std::vector<dvec4>& curve);
}

#endif
