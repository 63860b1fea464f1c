// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   SegmentSteps
 * @brief   into how many segments an edge may be cut
 *
 * The numbers of segments in ascending order, from 1. A step is a place in this order; of powers of
 * two it is the level.
 */
#ifndef SegmentSteps_h
#define SegmentSteps_h

#include "RelevoFiltersCoreModule.h" // for export macro

#include <vector> // for members

namespace relevo
{
class RELEVOFILTERSCORE_EXPORT SegmentSteps
{
public:
  /// 2^level segments for levels from 0 to the highest.
  static SegmentSteps MakePowersOfTwo(int highestLevel);

  /// 1 to 16 segments, then 9 to 16 times 2, 4 and 8.
  static SegmentSteps MakeWholeNumbers();
  static SegmentSteps Make(bool wholeNumbers);

  int GetNumberOfSteps() const { return static_cast<int>(this->Segments.size()); }
  int GetSegments(int step) const { return this->Segments[step]; }

  /// The lowest step with at least so many segments; the last one where there are none.
  int FindStep(int segments) const;

  /// Whether edges take any whole number of segments. The step of an edge whose tag lies in
  /// [0, MaximumLevel] is then that of 2^tag segments, rounded half up; else it is its level.
  bool AreWholeNumbers() const { return this->Whole; }
  static int GetWholeNumberStep(float tag);

private:
  std::vector<int> Segments;
  bool Whole = false;
};
}

#endif
