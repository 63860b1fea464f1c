// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ReducedProjection
 * @brief   has a view's camera project as it will in a frame that several processes draw
 *
 * ParaView draws smaller pictures while the view moves: IceT has the camera project to a corner of
 * the window, and so must what is prepared for it. Lasts as long as the object; then the camera has
 * the projection that it had.
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
  vtkCamera* Camera = nullptr; // nullptr where the picture has its full size
  // What the camera had.
  vtkSmartPointer<vtkMatrix4x4> Explicit;
  bool UsesExplicit = false;
};
}

#endif
