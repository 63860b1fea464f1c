// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   search for numbers of segments that satisfy error limits
 *
 * Private to the module.
 */
#ifndef SegmentSearch_h
#define SegmentSearch_h

#include <vector>

namespace relevo
{
class PatchDeviations;
class PatternExtents;

/// Returns the level of a curve that may deviate by `limit`: log2 of a number of segments of the
/// patterns, or more than their maximum.
float FindCurveLevel(const PatternExtents& patterns, double chord, double limit);

/**
 * Computes levels of edges, at most the maximum, from the error limits of the faces. Each edge
 * starts with the number that its curve requires. Then, for faces that deviate too much, the edges
 * with the fewest segments are raised, until there are no such faces or the maximum is reached.
 */
void FindEdgeLevels(const PatchDeviations& deviations, const PatternExtents& patterns,
  const std::vector<double>& limits, int maximumLevel, float* levels);
}

#endif
