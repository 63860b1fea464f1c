// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   replaces a scene by reliefs of it
 */
#ifndef ReliefCaptures_h
#define ReliefCaptures_h

class ViewerMessages;
class vtkRenderWindow;
class vtkRenderer;
struct ViewerOptions;

/// Captures the picture of the renderer, writes the captures and draws them in place of the scene,
/// each if the options request it. Throws ViewerError.
void ShowReliefs(vtkRenderer* renderer, vtkRenderWindow* window, const ViewerOptions& options,
  ViewerMessages& messages);

#endif
