// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ViewerScaleBar
 * @brief   a bar with a round length at the scale of the camera's focal point
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

/// The length at the camera's focal point that one pixel covers in a picture of this height.
double GetPixelLength(vtkCamera* camera, int height);

/// The largest number of the form 1, 2 or 5 times a power of ten that does not exceed a positive
/// length.
double GetRoundLength(double longest);

class ViewerScaleBar
{
public:
  /// Shows the bar in the lower right corner, in metres ("m") or in an unnamed unit (""). Must not
  /// outlive the renderer.
  ViewerScaleBar(vtkRenderer* renderer, const std::string& unit);
  ~ViewerScaleBar();
  ViewerScaleBar(const ViewerScaleBar&) = delete;
  void operator=(const ViewerScaleBar&) = delete;

private:
  void OnStart(vtkObject* caller, unsigned long event, void* data);
  std::string GetText(double length) const;

  vtkRenderer* Renderer;
  std::string Unit;
  vtkNew<vtkPoints> Points;
  vtkNew<vtkActor2D> Bar;
  vtkSmartPointer<vtkTextActor> Text;
  unsigned long Tag;
};

#endif
