// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   the cameras of captures
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
  /// A camera with the same view, in an image of this size, with an explicit projection; nullptr if
  /// all corners are behind it.
  vtkSmartPointer<vtkCamera> Camera;
  /// Whether there is no such camera because its matrices are singular.
  bool IsSingular = false;
  /// Depths of the near and far plane, which fit the corners closely.
  dvec2 Range = dvec2(0.0);
};

/**
 * Fit a camera to the corners of the visible scene. The smallest ratio of the near to the far
 * plane's depth in perspective is vtkRenderer's NearClippingPlaneTolerance; 0 uses its default.
 */
FittedCamera FitCamera(vtkCamera* camera, int width, int height, const std::vector<dvec3>& corners,
  double nearClippingPlaneTolerance);

/// Return a camera with the same view in an image of this size, plus a margin of pixels around it.
vtkSmartPointer<vtkCamera> WidenCamera(
  vtkCamera* camera, int width, int height, const ivec2& margin);

/// Return a parallel camera along a direction; the corners fill the image except for one pixel at
/// its sides.
vtkSmartPointer<vtkCamera> MakeCameraAlong(
  const dvec3& direction, int width, int height, const std::vector<dvec3>& corners);

/// Return the directions along x, -x, y, -y, z, -z.
std::vector<dvec3> GetBoxDirections();

/// Return the directions to the centre from the points of an icosahedron, whose faces are split in
/// four `level` times.
std::vector<dvec3> GetSphereDirections(int level);
}

#endif
