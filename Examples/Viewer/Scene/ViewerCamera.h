// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ViewerCamera
 * @brief   keeps the camera out of surfaces, and the near plane in front of them
 *
 * VTK's near plane is a fixed share of the far plane's distance: in close views of something large
 * it cuts away what is near.
 */
#ifndef ViewerCamera_h
#define ViewerCamera_h

#include "vtkType.h"

class vtkCamera;
class vtkObject;
class vtkRenderer;

class ViewerCamera
{
public:
  /// Before each frame, until it is destroyed.
  explicit ViewerCamera(vtkRenderer* renderer);
  virtual ~ViewerCamera();
  ViewerCamera(const ViewerCamera&) = delete;
  void operator=(const ViewerCamera&) = delete;

  /// Moves the camera of the renderer, if it has to be, and sets its clipping range.
  void Update();

protected:
  virtual void MoveOut(vtkCamera*) {}
  /// A distance that nothing visible is nearer to the camera than.
  virtual double GetMinimumDistance(vtkCamera* camera);

private:
  void OnStart(vtkObject*, unsigned long, void*);
  void OnClippingRange(vtkObject*, unsigned long, void*);

  vtkRenderer* Renderer;
  unsigned long Tags[2];
  vtkMTimeType CameraTime = 0; // when it was last as it has to be
};

#endif
