// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Displacements for the recipes of tests.
#ifndef RelevoDisplacements_h
#define RelevoDisplacements_h

#include "vtkDisplacement.h"
#include "vtkHeightField.h"
#include "vtkSmartPointer.h"

namespace RelevoMeshes
{
// Displaces along the normals. Without heights, only by the offset.
vtkSmartPointer<vtkDisplacement> MakeDisplacement(
  vtkHeightField* heights, double scale, double offset = 0.0);

vtkSmartPointer<vtkDisplacement> MakeDisplacementAlong(
  double x, double y, double z, vtkHeightField* heights, double scale);
}

#endif
