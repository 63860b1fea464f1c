// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   the position of a camera in model coordinates
 */
#ifndef CameraEye_h
#define CameraEye_h

#include "Mathematics/RefinementMathematics.h"
#include "RelevoFiltersCoreModule.h" // for export macro

class vtkCamera;
class vtkMatrix4x4;

namespace relevo
{
/**
 * Return a point in homogeneous coordinates, or with a parallel projection a direction towards the
 * viewer. The result uses the camera's matrices, so that oblique and off-axis projections are
 * supported.
 */
RELEVOFILTERSCORE_EXPORT dvec4 GetEye(vtkCamera* camera, vtkMatrix4x4* worldToModel);
}

#endif
