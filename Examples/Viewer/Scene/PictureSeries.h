// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   writes a picture for each position of a flight, or for each time step of a mesh
 */
#ifndef PictureSeries_h
#define PictureSeries_h

class ViewerMessages;
class ViewerScene;
class vtkRenderWindow;
struct ViewerOptions;

/// Creates the folder of the pictures, which are numbered from 0. Throws ViewerError.
void DrawFlight(ViewerScene& scene, vtkRenderWindow* window, const ViewerOptions& options,
  ViewerMessages& messages);

/// Likewise.
void DrawTimeSteps(ViewerScene& scene, vtkRenderWindow* window, const ViewerOptions& options,
  ViewerMessages& messages);

#endif
