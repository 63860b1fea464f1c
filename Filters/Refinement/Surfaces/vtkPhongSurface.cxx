// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPhongSurface.h"

#include "Arrays/PointArray.h"
#include "Checks/SettingChecks.h"
#include "Surfaces/BezierNormalCone.h"
#include "Surfaces/SurfaceCorners.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include "relevoNormalLinear.h"
#include "relevoPhong.h"
#include "relevoPhongAlpha.h"
#include "relevoPhongAlphaArray.h"

#include <algorithm>

namespace relevo
{
// Shaders for meshes with creases also work without creases.
#define RELEVO_DIRECTIONS

// The variants with one Alpha for the mesh, and with one per point.
struct PhongTriangle : SurfaceCorners
{
#include "glsl/relevoNormalLinear.glsl"
#include "glsl/relevoPhongAlpha.glsl"

#include "glsl/relevoPhong.glsl"
};

struct PhongTriangleOfArray : SurfaceCorners
{
  vec4 cornerValues(int i) const { return vec4(this->Face.Values[i][0]); }

#include "glsl/relevoNormalLinear.glsl"
#include "glsl/relevoPhongAlphaArray.glsl"

#include "glsl/relevoPhong.glsl"
};
}

vtkStandardNewMacro(vtkPhongSurface);

vtkPhongSurface::vtkPhongSurface()
{
  this->PreparationTime.Modified();
}

vtkPhongSurface::~vtkPhongSurface() = default;

void vtkPhongSurface::SetAlpha(double alpha)
{
  relevo::SetInRange(this, "Alpha", this->Alpha, alpha, 0.0, 1.0);
}

void vtkPhongSurface::SetAlphaArrayName(const char* name)
{
  const std::string value = name ? name : "";
  if (this->AlphaArrayName != value)
  {
    this->AlphaArrayName = value;
    this->Modified();
    this->PreparationTime.Modified();
  }
}

const char* vtkPhongSurface::GetAlphaArrayName()
{
  return this->AlphaArrayName.c_str();
}

bool vtkPhongSurface::GetPointValues(vtkPolyData* mesh, float* values, std::string& error)
{
  if (!relevo::TakePointArray(mesh, this->AlphaArrayName, 1, values, 1, error))
  {
    return false;
  }
  std::transform(values, values + mesh->GetNumberOfPoints(), values,
    [](float alpha) { return std::min(std::max(alpha, 0.0f), 1.0f); });
  return true;
}

void vtkPhongSurface::ComputeEdgeVectors(const Corner& from, const Corner& to, float* vectors)
{
  using relevo::SurfaceCorners;
  const glm::vec3 a = SurfaceCorners::Load(from.Point);
  const glm::vec3 b = SurfaceCorners::Load(to.Point);
  const glm::vec3 na = SurfaceCorners::Load(from.Normal);
  const glm::vec3 nb = SurfaceCorners::Load(to.Normal);
  // The mean of each end projected to the tangent plane of the other.
  const glm::vec3 edge = b - a;
  relevo::store(
    0.5f * (a + b) + 0.5f * (glm::dot(edge, nb) * nb - glm::dot(edge, na) * na), vectors);
}

void vtkPhongSurface::Evaluate(
  const Face& face, const float weights[3], float position[3], float normal[3])
{
  const auto evaluate = [&](auto triangle)
  {
    const glm::vec3 w = relevo::SurfaceCorners::Load(weights);
    relevo::store(triangle.surfacePosition(w), position);
    relevo::store(triangle.surfaceNormal(w), normal);
  };
  const relevo::SurfaceCorners corners{ face, 1 };
  if (face.Values[0])
  {
    evaluate(relevo::PhongTriangleOfArray{ corners });
  }
  else
  {
    evaluate(relevo::PhongTriangle{ corners, static_cast<float>(this->Alpha) });
  }
}

float vtkPhongSurface::ComputeNormalCone(const Face& face, float axis[3])
{
  if (face.Values[0])
  {
    return this->Superclass::ComputeNormalCone(face, axis);
  }
  const relevo::SurfaceCorners corners{ face, 1 };
  const float alpha = static_cast<float>(this->Alpha);
  const auto controlPoint = [&corners, alpha](int i, int j, int k)
  {
    if (std::max({ i, j, k }) == 2)
    {
      return corners.cornerPoint(i == 2 ? 0 : (j == 2 ? 1 : 2));
    }
    const int edge = k == 0 ? 0 : (i == 0 ? 1 : 2);
    const glm::vec3 middle =
      0.5f * (corners.cornerPoint(edge == 1 ? 1 : 0) + corners.cornerPoint(edge == 0 ? 1 : 2));
    return middle + alpha * (corners.edgeVector(edge, 0) - middle);
  };
  return relevo::ComputeBezierNormalCone(2, controlPoint, axis);
}

std::string vtkPhongSurface::GetShaderSource()
{
  return std::string(relevoNormalLinear) +
    (this->AlphaArrayName.empty() ? relevoPhongAlpha : relevoPhongAlphaArray) + relevoPhong;
}

std::vector<vtkRefinementSurface::Uniform> vtkPhongSurface::GetUniforms()
{
  return { { "relevoPhongAlpha", { static_cast<float>(this->Alpha) } } };
}

void vtkPhongSurface::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Alpha: " << this->Alpha << "\n";
  os << indent << "AlphaArrayName: " << this->AlphaArrayName << "\n";
}
