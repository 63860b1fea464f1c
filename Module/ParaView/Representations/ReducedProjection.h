// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ReducedProjection
 * @brief   has a view's camera project as it will in a frame that several processes draw
 *
 * ParaView draws smaller pictures while the view moves: IceT has the camera project to a corner of
 * the window, and so must what is prepared for it. Lasts as long as the object.
 *
 * Private to the module.
 */
#ifndef ReducedProjection_h
#define ReducedProjection_h

class vtkCamera;
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
};
}

#endif
