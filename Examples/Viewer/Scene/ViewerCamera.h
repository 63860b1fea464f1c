// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ViewerCamera
 * @brief   keeps the camera out of surfaces, and the near plane in front of them
 *
 * VTK's near plane is at a fixed fraction of the far plane's distance. In close views of large
 * objects it would clip near parts.
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
  /// Observes the renderer before each frame, until it is destroyed.
  explicit ViewerCamera(vtkRenderer* renderer);
  virtual ~ViewerCamera();
  ViewerCamera(const ViewerCamera&) = delete;
  void operator=(const ViewerCamera&) = delete;

  /// Moves the renderer's camera if necessary, and sets its clipping range.
  void Update();

protected:
  virtual void MoveOut(vtkCamera*) {}
  /// A lower bound for the distance of visible points from the camera.
  virtual double GetMinimumDistance(vtkCamera* camera);

private:
  void OnStart(vtkObject*, unsigned long, void*);
  void OnClippingRange(vtkObject*, unsigned long, void*);

  vtkRenderer* Renderer;
  unsigned long Tags[2];
  vtkMTimeType CameraTime = 0; // when it was last updated
};

#endif
