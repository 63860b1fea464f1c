// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Displacements that tests give their recipes.
#ifndef RelevoDisplacements_h
#define RelevoDisplacements_h

#include "vtkDisplacement.h"
#include "vtkHeightField.h"
#include "vtkSmartPointer.h"

namespace RelevoMeshes
{
// Along the normals; without heights by the offset alone.
vtkSmartPointer<vtkDisplacement> MakeDisplacement(
  vtkHeightField* heights, double scale, double offset = 0.0);

vtkSmartPointer<vtkDisplacement> MakeDisplacementAlong(
  double x, double y, double z, vtkHeightField* heights, double scale);
}

#endif
