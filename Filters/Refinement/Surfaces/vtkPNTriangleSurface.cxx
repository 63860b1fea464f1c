// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPNTriangleSurface.h"

#include "Surfaces/PNPatch.h"
#include "vtkObjectFactory.h"

#include "relevoNormalLinear.h"
#include "relevoNormalQuadratic.h"
#include "relevoNormalQuadraticSum.h"

namespace relevo
{
namespace
{
struct LinearNormals : SurfaceCorners
{
#include "glsl/relevoNormalLinear.glsl"
};
}
}

vtkStandardNewMacro(vtkPNTriangleSurface);

vtkPNTriangleSurface::vtkPNTriangleSurface() = default;
vtkPNTriangleSurface::~vtkPNTriangleSurface() = default;

void vtkPNTriangleSurface::ComputeEdgeVectors(const Corner& from, const Corner& to, float* vectors)
{
  relevo::StorePNEdge(from, to, vectors);
  if (this->QuadraticNormals)
  {
    relevo::StorePNMiddleNormal(from, to, vectors + 6);
  }
}

void vtkPNTriangleSurface::ComputeFaceVectors(const Face& face, float* vectors, float* [3])
{
  relevo::store(relevo::GetPNCenter({ face, 2 + this->GetNumberOfEdgeNormals() }), vectors);
}

void vtkPNTriangleSurface::Evaluate(
  const Face& face, const float weights[3], float position[3], float normal[3])
{
  const relevo::SurfaceCorners corners{ face, 2 + this->GetNumberOfEdgeNormals() };
  const glm::vec3 w = relevo::SurfaceCorners::Load(weights);
  relevo::store(relevo::PNTriangle{ corners }.surfacePosition(w), position);
  relevo::store(this->QuadraticNormals ? relevo::QuadraticNormals{ { corners } }.surfaceNormal(w)
                                       : relevo::LinearNormals{ corners }.surfaceNormal(w),
    normal);
}

float vtkPNTriangleSurface::ComputeNormalCone(const Face& face, float axis[3])
{
  return relevo::ComputePNNormalCone({ face, 2 + this->GetNumberOfEdgeNormals() }, axis);
}

std::string vtkPNTriangleSurface::GetShaderSource()
{
  const std::string normals = this->QuadraticNormals
    ? std::string(relevoNormalQuadraticSum) + relevoNormalQuadratic
    : std::string(relevoNormalLinear);
  return relevo::GetPNTriangleSource() + normals;
}

void vtkPNTriangleSurface::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "QuadraticNormals: " << (this->QuadraticNormals ? "On\n" : "Off\n");
}
