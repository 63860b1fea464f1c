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

/**
 * Draws frames until the time of one is known, and prints what they cost; throws ViewerError.
 */
void PrintStatistics(vtkAdaptiveRefinementMapper* mapper, vtkRenderer* renderer,
  vtkRenderWindow* window, ViewerMessages& messages, std::ostream& stream);

#endif
