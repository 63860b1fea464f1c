// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   numbers of segments with which no face deviates by more than it may
 *
 * Private to the module's own sources.
 */
#ifndef SegmentSearch_h
#define SegmentSearch_h

#include <vector>

namespace relevo
{
class PatchDeviations;
class PatternExtents;

/// The level of a curve that may deviate by `limit`: log2 of a number of segments of the patterns,
/// or more than they have.
float FindCurveLevel(const PatternExtents& patterns, double chord, double limit);

/**
 * Levels of edges, of which none is more than the maximum, by what each face may deviate. Each edge
 * has what its own curve needs; then the least edges of faces whose patterns deviate too much get
 * more, until there are none or no more levels.
 */
void FindEdgeLevels(const PatchDeviations& deviations, const PatternExtents& patterns,
  const std::vector<double>& limits, int maximumLevel, float* levels);
}

#endif
