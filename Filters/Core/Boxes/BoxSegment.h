// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   BoxSegment
 * @brief   a segment that boxes are tested against: points Start + t Direction with t in [0, 1]
 *
 * Private to the modules' own sources.
 */
#ifndef BoxSegment_h
#define BoxSegment_h

#include "Boxes/BoundingBox.h"
#include "RelevoFiltersCoreModule.h" // for export macro

namespace relevo
{
struct RELEVOFILTERSCORE_EXPORT BoxSegment
{
  BoxSegment(const double start[3], const double end[3], double margin);
  /// Where the segment enters a box that is widened by the margin; more than `last` where it does
  /// not enter before.
  double GetEntry(const BoundingBox<float>& box, double last) const;

  double Start[3];
  double Inverse[3]; // of the direction
  bool Still[3];     // directions of zero
  double Margin;
};
}

#endif
