// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   reliefs of what a scene shows, in its place
 */
#ifndef ReliefCaptures_h
#define ReliefCaptures_h

class ViewerMessages;
class vtkRenderWindow;
class vtkRenderer;
struct ViewerOptions;

/// Captures what the renderer has drawn, writes the captures and draws them in its place, each
/// where the options ask for it; throws ViewerError.
void ShowReliefs(vtkRenderer* renderer, vtkRenderWindow* window, const ViewerOptions& options,
  ViewerMessages& messages);

#endif
