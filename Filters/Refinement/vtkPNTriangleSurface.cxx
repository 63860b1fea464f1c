// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPNTriangleSurface.h"

#include "vtkObjectFactory.h"
#include "vtkSurfaceCorners.h"

#include "relevoNormalLinear.h"
#include "relevoNormalQuadratic.h"
#include "relevoPNTriangle.h"

#include <algorithm>
#include <cmath>

namespace relevo
{
struct PNTriangle : SurfaceCorners
{
#include "glsl/relevoPNTriangle.glsl"
};

struct LinearNormals : SurfaceCorners
{
#include "glsl/relevoNormalLinear.glsl"
};

struct QuadraticNormals : SurfaceCorners
{
#include "glsl/relevoNormalQuadratic.glsl"
};
}

vtkStandardNewMacro(vtkPNTriangleSurface);

vtkPNTriangleSurface::vtkPNTriangleSurface() = default;
vtkPNTriangleSurface::~vtkPNTriangleSurface() = default;

void vtkPNTriangleSurface::ComputeEdgeVectors(const Corner& from, const Corner& to, float* vectors)
{
  using relevo::SurfaceCorners;
  const glm::vec3 a = SurfaceCorners::load(from.Point);
  const glm::vec3 b = SurfaceCorners::load(to.Point);
  const glm::vec3 na = SurfaceCorners::load(from.Normal);
  const glm::vec3 nb = SurfaceCorners::load(to.Normal);
  const glm::vec3 edge = b - a;
  // On a straight edge the thirds themselves: (2 a + b) / 3 without its rounding.
  relevo::store(a + (edge - glm::dot(edge, na) * na) / 3.0f, vectors);
  relevo::store(b - (edge - glm::dot(edge, nb) * nb) / 3.0f, vectors + 3);
  if (this->QuadraticNormals)
  {
    const float squared = glm::dot(edge, edge);
    const float v = squared > 0.0f ? 2.0f * glm::dot(edge, na + nb) / squared : 0.0f;
    relevo::store(relevo::unitVector(na + nb - v * edge), vectors + 6);
  }
}

void vtkPNTriangleSurface::ComputeFaceVectors(const Face& face, float* vectors, float* [3])
{
  const relevo::SurfaceCorners corners{ face, 2 + this->GetNumberOfEdgeNormals() };
  glm::vec3 edges(0.0f);
  for (int edge = 0; edge < 3; ++edge)
  {
    edges += corners.edgeVector(edge, 0) + corners.edgeVector(edge, 1);
  }
  edges /= 6.0f;
  const glm::vec3 middle =
    (corners.cornerPoint(0) + corners.cornerPoint(1) + corners.cornerPoint(2)) / 3.0f;
  relevo::store(edges + 0.5f * (edges - middle), vectors);
}

void vtkPNTriangleSurface::Evaluate(
  const Face& face, const float weights[3], float position[3], float normal[3])
{
  const int vectorsPerEdge = 2 + this->GetNumberOfEdgeNormals();
  const relevo::SurfaceCorners corners{ face, vectorsPerEdge };
  const glm::vec3 w = relevo::SurfaceCorners::load(weights);
  relevo::store(relevo::PNTriangle{ corners }.surfacePosition(w), position);
  relevo::store(this->QuadraticNormals ? relevo::QuadraticNormals{ corners }.surfaceNormal(w)
                                       : relevo::LinearNormals{ corners }.surfaceNormal(w),
    normal);
}

float vtkPNTriangleSurface::ComputeNormalCone(const Face& face, float axis[3])
{
  // The patch's tangents along two sides are convex combinations of the differences of control
  // points, and its normals positive ones of their products.
  const relevo::SurfaceCorners corners{ face, 2 + this->GetNumberOfEdgeNormals() };
  const auto controlPoint = [&corners](int i, int j, int k)
  {
    // Powers of the weights of corners 0, 1, 2.
    if (std::max({ i, j, k }) == 3)
    {
      return corners.cornerPoint(i == 3 ? 0 : (j == 3 ? 1 : 2));
    }
    if (i == 0)
    {
      return corners.edgeVector(1, j == 2 ? 0 : 1);
    }
    if (j == 0)
    {
      return corners.edgeVector(2, i == 2 ? 0 : 1);
    }
    return k == 0 ? corners.edgeVector(0, i == 2 ? 0 : 1) : corners.faceVector(0);
  };
  glm::vec3 along[6];
  glm::vec3 across[6];
  int count = 0;
  for (int i = 0; i <= 2; ++i)
  {
    for (int j = 0; i + j <= 2; ++j)
    {
      const int k = 2 - i - j;
      const glm::vec3 from = controlPoint(i + 1, j, k);
      along[count] = controlPoint(i, j + 1, k) - from;
      across[count] = controlPoint(i, j, k + 1) - from;
      ++count;
    }
  }
  glm::vec3 normals[36];
  glm::vec3 sum(0.0f);
  for (int n = 0; n < 36; ++n)
  {
    normals[n] = relevo::unitVector(glm::cross(along[n / 6], across[n % 6]));
    sum += normals[n];
  }
  const glm::vec3 mean = relevo::unitVector(sum);
  float cosine = glm::dot(mean, mean) > 0.0f ? 1.0f : 0.0f;
  for (const glm::vec3& normal : normals)
  {
    if (glm::dot(normal, normal) > 0.0f)
    {
      cosine = std::min(cosine, glm::dot(normal, mean));
    }
  }
  relevo::store(mean, axis);
  // Flat triangles between points of the patch are turned a little more than the patch.
  constexpr float margin = 0.05f;
  return cosine > margin ? std::cos(std::acos(std::min(cosine, 1.0f)) + margin) : 0.0f;
}

std::string vtkPNTriangleSurface::GetShaderSource()
{
  return std::string(relevoPNTriangle) +
    (this->QuadraticNormals ? relevoNormalQuadratic : relevoNormalLinear);
}

void vtkPNTriangleSurface::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "QuadraticNormals: " << (this->QuadraticNormals ? "On\n" : "Off\n");
}
