// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRefinementSurface.h"

vtkRefinementSurface::vtkRefinementSurface() = default;
vtkRefinementSurface::~vtkRefinementSurface() = default;

void vtkRefinementSurface::ComputeEdgeVectors(
  const float*, const float*, const float*, const float*, float*)
{
}

void vtkRefinementSurface::ComputeFacePositions(const float*, const float* [3], float*)
{
}

float vtkRefinementSurface::ComputeNormalCone(const Face&, float axis[3])
{
  axis[0] = axis[1] = axis[2] = 0.0f;
  return 0.0f;
}

void vtkRefinementSurface::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
