// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RelevoDisplacements.h"

namespace RelevoMeshes
{
vtkSmartPointer<vtkDisplacement> MakeDisplacement(
  vtkHeightField* heights, double scale, double offset)
{
  auto displacement = vtkSmartPointer<vtkDisplacement>::New();
  displacement->SetHeightMap(heights);
  displacement->SetScale(scale);
  displacement->SetOffset(offset);
  return displacement;
}

vtkSmartPointer<vtkDisplacement> MakeDisplacementAlong(
  double x, double y, double z, vtkHeightField* heights, double scale)
{
  auto displacement = MakeDisplacement(heights, scale);
  displacement->SetDirection(x, y, z);
  return displacement;
}
}
