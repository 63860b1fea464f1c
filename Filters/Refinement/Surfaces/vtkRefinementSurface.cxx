// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRefinementSurface.h"

vtkRefinementSurface::vtkRefinementSurface() = default;
vtkRefinementSurface::~vtkRefinementSurface() = default;

bool vtkRefinementSurface::GetPointValues(vtkPolyData*, float*, std::string&)
{
  return true;
}

bool vtkRefinementSurface::BuildTables(vtkPolyData*, const double[3], Tables&, std::string&)
{
  return true;
}

void vtkRefinementSurface::ComputeEdgeVectors(const Corner&, const Corner&, float*)
{
}

void vtkRefinementSurface::ComputeFaceVectors(const Face&, float*, float* [3])
{
}

bool vtkRefinementSurface::SplitsNormals(const Face&)
{
  return false;
}

void vtkRefinementSurface::EvaluateDirection(
  const Face& face, const float weights[3], float direction[3])
{
  float position[3];
  this->Evaluate(face, weights, position, direction);
}

vtkDataArray* vtkRefinementSurface::FindCoefficients(vtkPolyData*, vtkDataArray*)
{
  return nullptr;
}

void vtkRefinementSurface::EvaluateField(const Face&, const float[3], vtkDataArray*, double*)
{
}

void vtkRefinementSurface::ExtendBox(const Face&, double[3], double[3])
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
