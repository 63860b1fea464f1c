// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Window/DrawnPoint.h"

#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkRenderer.h"

#include <cmath>

//------------------------------------------------------------------------------
bool GetDrawnPoint(vtkRenderer* renderer, const int pixel[2], double point[3])
{
  const int* size = renderer->GetSize();
  if (pixel[0] < 0 || pixel[0] >= size[0] || pixel[1] < 0 || pixel[1] >= size[1])
  {
    return false;
  }
  const double depth = renderer->GetZ(pixel[0], pixel[1]);
  // Texts over the picture have depth 0, the background has depth 1.
  if (!(depth > 0.0 && depth < 1.0))
  {
    return false;
  }
  double clip[4] = { 2.0 * (pixel[0] + 0.5) / size[0] - 1.0, 2.0 * (pixel[1] + 0.5) / size[1] - 1.0,
    2.0 * depth - 1.0, 1.0 };
  vtkNew<vtkMatrix4x4> toWorld;
  vtkMatrix4x4::Invert(renderer->GetActiveCamera()->GetCompositeProjectionTransformMatrix(
                         renderer->GetTiledAspectRatio(), -1.0, 1.0),
    toWorld);
  toWorld->MultiplyPoint(clip, clip);
  for (int i = 0; i < 3; ++i)
  {
    point[i] = clip[i] / clip[3];
  }
  return std::isfinite(point[0] + point[1] + point[2]);
}
