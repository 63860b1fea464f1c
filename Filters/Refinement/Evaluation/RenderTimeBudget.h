// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   RenderTimeBudget
 * @brief   how many triangles may be drawn in a given time, from the times of the latest frames
 *
 * What a triangle costs is the median of five frames, so that single frames that took long count
 * for nothing. The frame that follows a change by more than a quarter in the number of triangles is
 * left out: patterns are made and sent then, and the GPU's time is that of the frame before.
 *
 * A limit is set to what takes 85 % of the time allowed, and stands while it takes between 70 % and
 * 100 % by what is known: it follows the load and the scene, not the noise of the clock. A cost
 * that frames have whatever they draw makes smaller steps of the way there, never larger ones:
 * limits do not swing.
 *
 * More than 2 s are allowed for still pictures, which have no limit.
 *
 * Knows no clock. Not wrapped: for the modules' own sources.
 */
#ifndef RenderTimeBudget_h
#define RenderTimeBudget_h

#include "RelevoFiltersRefinementModule.h" // for export macro
#include "vtkType.h"                       // for vtkIdType

#include <vector> // for members

namespace relevo
{
class RELEVOFILTERSREFINEMENT_EXPORT RenderTimeBudget
{
public:
  /// A frame has drawn that many triangles in that many seconds.
  void AddFrame(vtkIdType triangles, double seconds);

  /// 0 as long as nothing is known.
  double GetSecondsPerTriangle() const { return this->Cost; }

  /**
   * The most triangles to draw in that many seconds, 0 for any number. `last` is what was said last
   * for the same view.
   */
  vtkIdType FindLimit(double seconds, vtkIdType last) const;

private:
  vtkIdType Triangles = 0; // of the last frame
  std::vector<double> Costs;
  double Cost = 0.0;
};
}

#endif
