// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   SegmentSteps
 * @brief   the allowed numbers of segments of an edge
 *
 * The numbers are in ascending order from 1. A step is an index into them. For powers of two, it is
 * the level.
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

  /// The lowest step with at least this number of segments, or the last step.
  int FindStep(int segments) const;

  /// Whether edges can have any whole number of segments. The step of an edge with a tag in
  /// [0, MaximumLevel] is then that of 2^tag segments, rounded half up. Otherwise the step is the
  /// level.
  bool AreWholeNumbers() const { return this->Whole; }
  static int GetWholeNumberStep(float tag);

private:
  std::vector<int> Segments;
  bool Whole = false;
};
}

#endif
