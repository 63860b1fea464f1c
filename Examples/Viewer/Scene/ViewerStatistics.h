// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   statistics of frames
 */
#ifndef ViewerStatistics_h
#define ViewerStatistics_h

#include <iosfwd>

class vtkAdaptiveRefinementMapper;
class vtkRenderer;
class vtkRenderWindow;
class ViewerMessages;

/// Draws twice and returns the time of the second frame in milliseconds, which builds nothing.
/// Throws ViewerError.
double MeasureFrame(vtkRenderer* renderer, vtkRenderWindow* window, ViewerMessages& messages);

/**
 * Draws twice, measures the second frame, which builds nothing, and prints statistics. Throws
 * ViewerError.
 */
void DrawWithStatistics(vtkAdaptiveRefinementMapper* mapper, vtkRenderer* renderer,
  vtkRenderWindow* window, ViewerMessages& messages, std::ostream& stream);

#endif
