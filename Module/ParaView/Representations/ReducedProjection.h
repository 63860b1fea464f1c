// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ReducedProjection
 * @brief   sets the projection that a view's camera has in a frame of several processes
 *
 * ParaView draws smaller images while the view moves: IceT makes the camera project to a corner of
 * the window, so preparations must do the same. The destructor restores the camera's projection.
 *
 * Private to the module.
 */
#ifndef ReducedProjection_h
#define ReducedProjection_h

#include "vtkSmartPointer.h"

class vtkCamera;
class vtkMatrix4x4;
class vtkPVRenderView;

namespace relevo
{
class ReducedProjection
{
public:
  explicit ReducedProjection(vtkPVRenderView* view);
  ~ReducedProjection();
  ReducedProjection(const ReducedProjection&) = delete;
  void operator=(const ReducedProjection&) = delete;

private:
  vtkCamera* Camera = nullptr; // nullptr if the image has its full size
  // The camera's previous projection.
  vtkSmartPointer<vtkMatrix4x4> Explicit;
  bool UsesExplicit = false;
};
}

#endif
