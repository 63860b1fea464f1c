// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLinearSurface.h"

#include "Surfaces/SurfaceCorners.h"
#include "vtkObjectFactory.h"

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
  const glm::vec3 w = evaluator.Load(weights);
  relevo::store(evaluator.surfacePosition(w), position);
  relevo::store(evaluator.surfaceNormal(w), normal);
}

float vtkLinearSurface::ComputeNormalCone(const Face& face, float axis[3])
{
  const glm::vec3 origin = relevo::SurfaceCorners::Load(face.Points[0]);
  const glm::vec3 normal =
    relevo::unitVector(glm::cross(relevo::SurfaceCorners::Load(face.Points[1]) - origin,
      relevo::SurfaceCorners::Load(face.Points[2]) - origin));
  relevo::store(normal, axis);
  return glm::dot(normal, normal) > 0.0f ? 1.0f : 0.0f;
}

std::string vtkLinearSurface::GetShaderSource()
{
  return std::string(relevoLinear) + relevoNormalLinear;
}

void vtkLinearSurface::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
