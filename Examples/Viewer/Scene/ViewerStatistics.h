// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   what the frames of a scene cost
 */
#ifndef ViewerStatistics_h
#define ViewerStatistics_h

#include <iosfwd>

class vtkAdaptiveRefinementMapper;
class vtkRenderer;
class vtkRenderWindow;
class ViewerMessages;

/// Draws, once more for a frame that has nothing to make any more, and returns the milliseconds of
/// that; throws ViewerError.
double MeasureFrame(vtkRenderer* renderer, vtkRenderWindow* window, ViewerMessages& messages);

/**
 * Draws, once more for the time of a frame that has nothing to make any more, and prints what it
 * costs; throws ViewerError.
 */
void DrawWithStatistics(vtkAdaptiveRefinementMapper* mapper, vtkRenderer* renderer,
  vtkRenderWindow* window, ViewerMessages& messages, std::ostream& stream);

#endif
