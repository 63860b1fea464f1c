// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   where a camera looks from, in the coordinates of a mesh
 *
 * Private to the modules' own sources.
 */
#ifndef CameraEye_h
#define CameraEye_h

#include "Core/RefinementMathematics.h"
#include "RelevoFiltersVolumeModule.h" // for export macro

class vtkCamera;
class vtkMatrix4x4;

namespace relevo
{
/**
 * As VisibilityOrder takes it: a place in homogeneous coordinates or, of a parallel projection, a
 * direction towards the viewer. By the camera's matrices: oblique and off-axis ones count.
 */
RELEVOFILTERSVOLUME_EXPORT dvec4 GetEye(vtkCamera* camera, vtkMatrix4x4* worldToMesh);
}

#endif
