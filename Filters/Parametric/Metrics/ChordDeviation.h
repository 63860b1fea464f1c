// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   how far a rational Bézier curve is from chords of equal parameter intervals
 *
 * Of S = A / w the second derivative is N / w^3 with C = A' w - A w' and N = C' w - 2 C w'. N and
 * w^3 are Bézier curves of one degree, and w^3 has positive control values, so that no |S''| is
 * more than the largest ratio of control points of N to control values of w^3. N does not depend on
 * the origin of A.
 *
 * Private to the module's own sources.
 */
#ifndef ChordDeviation_h
#define ChordDeviation_h

#include "Mathematics/RefinementMathematics.h"

#include <vector> // for points

namespace relevo
{
/// A curve of homogeneous points cut into n equal segments is off by no more than this over n^2.
double ComputeChordDeviation(const std::vector<dvec4>& curve);
}

#endif
