// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLinearSurface.h"

#include "vtkObjectFactory.h"
#include "vtkSurfaceCorners.h"

#include "relevoLinear.h"
#include "relevoNormalLinear.h"

namespace relevo
{
struct LinearEvaluator : SurfaceCorners
{
#include "glsl/relevoLinear.glsl"
#include "glsl/relevoNormalLinear.glsl"
};
}

vtkStandardNewMacro(vtkLinearSurface);

vtkLinearSurface::vtkLinearSurface() = default;
vtkLinearSurface::~vtkLinearSurface() = default;

void vtkLinearSurface::Evaluate(
  const Face& face, const float weights[3], float position[3], float normal[3])
{
  relevo::LinearEvaluator evaluator{ { face, 0 } };
  const glm::vec3 w = evaluator.load(weights);
  const glm::vec3 p = evaluator.surfacePosition(w);
  const glm::vec3 n = evaluator.surfaceNormal(w);
  for (int i = 0; i < 3; ++i)
  {
    position[i] = p[i];
    normal[i] = n[i];
  }
}

std::string vtkLinearSurface::GetShaderSource()
{
  return std::string(relevoLinear) + relevoNormalLinear;
}

void vtkLinearSurface::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
