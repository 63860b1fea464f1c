// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "View/CameraEye.h"

#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"

#include <initializer_list>

namespace relevo
{
// The eye is the point that the camera projects to (0, 0, 1, 0).
dvec4 GetEye(vtkCamera* camera, vtkMatrix4x4* worldToModel)
{
  dvec4 eye(0.0, 0.0, 1.0, 0.0);
  vtkNew<vtkMatrix4x4> inverse;
  for (vtkMatrix4x4* matrix :
    { camera->GetProjectionTransformMatrix(1.0, -1.0, 1.0), camera->GetViewTransformMatrix() })
  {
    vtkMatrix4x4::Invert(matrix, inverse);
    inverse->MultiplyPoint(&eye.x, &eye.x);
  }
  worldToModel->MultiplyPoint(&eye.x, &eye.x);
  // Depth increases away from the viewer.
  return eye.w == 0.0 ? -eye : eye;
}
}
