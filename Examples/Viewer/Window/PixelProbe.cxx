// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Window/PixelProbe.h"

#include "Scene/ViewerScene.h"
#include "Window/DrawnPoint.h"
#include "Window/ViewerScaleBar.h"

#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkRenderer.h"

#include <cmath>

namespace
{
// The length that a pixel covers at this point.
double GetResolution(vtkRenderer* renderer, const double point[3])
{
  vtkCamera* camera = renderer->GetActiveCamera();
  const double pixel = GetPixelLength(camera, renderer->GetSize()[1]);
  return camera->GetParallelProjection()
    ? pixel
    : pixel * std::sqrt(vtkMath::Distance2BetweenPoints(point, camera->GetPosition())) /
      camera->GetDistance();
}
}

//------------------------------------------------------------------------------
std::optional<std::array<double, 3>> FindVisiblePoint(ViewerScene& scene, const int pixel[2])
{
  std::array<double, 3> point;
  const bool isFound =
    GetDrawnPoint(scene.GetRenderer(), pixel, point.data()) || scene.FindPoint(pixel, point.data());
  return isFound ? std::optional<std::array<double, 3>>(point) : std::nullopt;
}

//------------------------------------------------------------------------------
std::string DescribeSurface(ViewerScene& scene, const int pixel[2])
{
  vtkRenderer* renderer = scene.GetRenderer();
  double point[3];
  return GetDrawnPoint(renderer, pixel, point)
    ? scene.Describe(point, GetResolution(renderer, point))
    : std::string();
}

//------------------------------------------------------------------------------
std::string DescribeVisible(ViewerScene& scene, const int pixel[2])
{
  const std::string text = DescribeSurface(scene, pixel);
  return text.empty() ? scene.DescribePixel(pixel) : text;
}
