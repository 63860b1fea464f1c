// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   cameras that captures are made with
 *
 * Private to the module.
 */
#ifndef FittedCamera_h
#define FittedCamera_h

#include "Mathematics/RefinementMathematics.h"
#include "vtkSmartPointer.h"

#include <vector>

class vtkCamera;

namespace relevo
{
struct FittedCamera
{
  /// Sees what the other sees in a picture of this many pixels, by an explicit projection; nullptr
  /// if none of the corners is in front of it.
  vtkSmartPointer<vtkCamera> Camera;
  /// Whether there is no such camera as its matrices have no inverse.
  bool IsSingular = false;
  /// Depths of the near and far plane, which are close around the corners.
  dvec2 Range = dvec2(0.0);
};

/**
 * The corners are those of what is to be seen. The least share of the far plane's depth that the
 * near plane of a perspective has is vtkRenderer's NearClippingPlaneTolerance; 0 for its default.
 */
FittedCamera FitCamera(vtkCamera* camera, int width, int height, const std::vector<dvec3>& corners,
  double nearClippingPlaneTolerance);

/// Sees what the other sees in a picture of this many pixels, and a margin of more pixels around.
vtkSmartPointer<vtkCamera> WidenCamera(
  vtkCamera* camera, int width, int height, const ivec2& margin);

/// In parallel, along a direction; the corners fill the picture but for a pixel at its sides.
vtkSmartPointer<vtkCamera> MakeCameraAlong(
  const dvec3& direction, int width, int height, const std::vector<dvec3>& corners);

/// Along x, -x, y, -y, z, -z.
std::vector<dvec3> GetBoxDirections();

/// From the points of an icosahedron whose faces were split in four so often to its middle.
std::vector<dvec3> GetSphereDirections(int level);
}

#endif
