// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   RenderTimeBudget
 * @brief   limits the number of triangles for a given frame time, from the times of previous frames
 *
 * The cost of a triangle is the median of five frames, so that single slow frames have no effect.
 * The frame after a change in the number of triangles by more than a quarter is skipped: it
 * generates and uploads patterns, and its GPU time is that of the previous frame.
 *
 * A limit is set so that 85 % of the frame time is used, and it does not change while the estimate
 * is between 70 % and 100 %. It follows the load and the scene, but not the noise of the clock. A
 * constant cost per frame makes the steps towards the limit smaller, never larger, so that limits
 * do not oscillate.
 *
 * A frame time of more than 2 s is that of still images, which have no limit.
 *
 * This class does not measure times.
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
  /// Add the number of triangles and the time of a frame.
  void AddFrame(vtkIdType triangles, double seconds);

  /// 0 until the cost is known.
  double GetSecondsPerTriangle() const { return this->Cost; }

  /**
   * Return the highest number of triangles for this frame time, or 0 for no limit. `last` is the
   * last result for the same view.
   */
  vtkIdType FindLimit(double seconds, vtkIdType last) const;

private:
  vtkIdType Triangles = 0; // in the last frame
  std::vector<double> Costs;
  double Cost = 0.0;
};
}

#endif
