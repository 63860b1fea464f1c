// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   where a camera looks from, in the coordinates of what it looks at
 *
 * Private to the modules' own sources.
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
 * A place in homogeneous coordinates or, of a parallel projection, a
 * direction towards the viewer. By the camera's matrices: oblique and off-axis ones count.
 */
RELEVOFILTERSCORE_EXPORT dvec4 GetEye(vtkCamera* camera, vtkMatrix4x4* worldToModel);
}

#endif
