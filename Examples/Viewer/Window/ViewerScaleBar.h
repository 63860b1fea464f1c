// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ViewerScaleBar
 * @brief   a bar of a round length, as long as things are across the picture where the camera looks
 */
#ifndef ViewerScaleBar_h
#define ViewerScaleBar_h

#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <string>

class vtkActor2D;
class vtkCamera;
class vtkObject;
class vtkPoints;
class vtkRenderer;
class vtkTextActor;

/// The length at the camera's focal point that is as long as a pixel of a picture of that height.
double GetPixelLength(vtkCamera* camera, int height);

/// The largest of 1, 2 and 5 times a power of ten that is no more than a length above 0.
double GetRoundLength(double longest);

class ViewerScaleBar
{
public:
  /// In the lower right corner. Lengths in metres ("m") or in a unit without a name (""). Is
  /// there until the renderer has drawn its last frame.
  ViewerScaleBar(vtkRenderer* renderer, const std::string& unit);
  ~ViewerScaleBar();

private:
  void OnStart(vtkObject* caller, unsigned long event, void* data);
  std::string GetText(double length) const;

  std::string Unit;
  vtkNew<vtkPoints> Points;
  vtkNew<vtkActor2D> Bar;
  vtkSmartPointer<vtkTextActor> Text;
};

#endif
