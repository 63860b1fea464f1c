// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   reliefs in a scene
 */
#ifndef ReliefActor_h
#define ReliefActor_h

#include "vtkSmartPointer.h"

class ViewerMessages;
class vtkActor;
class vtkMultiBlockDataSet;
class vtkRenderWindow;
class vtkRenderer;
struct ViewerOptions;

/// Makes an actor that draws the reliefs as the options say.
vtkSmartPointer<vtkActor> MakeReliefActor(
  vtkMultiBlockDataSet* reliefs, const ViewerOptions& options, ViewerMessages& messages);

/// Draws a frame, and prints statistics on stdout if the options request them. Throws ViewerError.
void DrawReliefs(vtkActor* actor, vtkRenderer* renderer, vtkRenderWindow* window,
  const ViewerOptions& options, ViewerMessages& messages);

#endif
