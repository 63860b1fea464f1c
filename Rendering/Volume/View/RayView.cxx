// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "View/RayView.h"

#include "OpenGL/ShaderUniforms.h"
#include "View/CameraEye.h"
#include "View/WorldView.h"

#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <cmath>

namespace relevo
{
namespace
{
// Not at the far plane, where depths of a perspective view are close together.
constexpr double LargestMiddle = 0.99999;
// Of a mesh in the world; shaders multiply it by small numbers.
constexpr double LargestLength = 1e36;

dvec4 FindEye(vtkCamera* camera, vtkMatrix4x4* dataToWorld, const dvec3& center, double radius)
{
  vtkNew<vtkMatrix4x4> meshToWorld;
  for (int i = 0; i < 3; ++i)
  {
    meshToWorld->SetElement(i, i, radius);
    meshToWorld->SetElement(i, 3, center[i]);
  }
  vtkMatrix4x4::Multiply4x4(dataToWorld, meshToWorld, meshToWorld);
  vtkNew<vtkMatrix4x4> worldToMesh;
  vtkMatrix4x4::Invert(meshToWorld, worldToMesh);
  return relevo::GetEye(camera, worldToMesh);
}
}

bool RayView::Compute(
  vtkRenderer* renderer, vtkMatrix4x4* matrix, const dvec3& center, double radius)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  const dmat4 projection =
    MakeMatrix(camera->GetProjectionTransformMatrix(renderer->GetTiledAspectRatio(), -1.0, 1.0));
  const dmat4 worldToClip = projection * MakeMatrix(camera->GetViewTransformMatrix());
  const dmat4 dataToWorld = MakeMatrix(matrix);
  this->Eye = FindEye(camera, matrix, center, radius);
  dmat4 meshToData(radius);
  meshToData[3] = dvec4(center, 1.0);
  const dmat4 meshToWorld = dataToWorld * meshToData;
  const dmat4 meshToClip = worldToClip * meshToWorld;
  this->MeshToClip = meshToClip;
  this->MeshToWorld = meshToWorld;
  this->GradientToWorld = transpose(inverse(dmat3(dataToWorld)));
  const dmat4 clipToMesh = inverse(meshToClip);

  // The depth of the mesh's centre, if it is visible, so that rays begin near it.
  const dvec4 middle = meshToClip[3];
  const double z = middle.w > 0.0 ? std::clamp(middle.z / middle.w, -1.0, LargestMiddle) : -1.0;
  const dvec4 origin = clipToMesh[3] + z * clipToMesh[2];
  this->Middle = origin / origin.w;
  this->X = clipToMesh[0] / origin.w;
  this->Y = clipToMesh[1] / origin.w;
  this->Z = clipToMesh[2] / origin.w;
  this->Range = dvec2(-1.0 - z, 1.0 - z);
  this->MiddleZ = z;
  this->MiddleWeight = 1.0 / origin.w;
  const dvec4 sum = this->Middle + this->X + this->Y + this->Z;
  return std::isfinite(dot(sum, dvec4(1.0)));
}

bool RayView::IsInFront(const dvec3& half) const
{
  return this->AreCornersAbove(half, dvec4(0.0, 0.0, 0.0, 1.0));
}

bool RayView::IsBeyondNear(const dvec3& half) const
{
  return this->AreCornersAbove(half, dvec4(0.0, 0.0, 1.0, 1.0));
}

double RayView::GetDepth(const dvec3& point) const
{
  const dvec4 seen = this->MeshToClip * dvec4(point, 1.0);
  return seen.z / seen.w - this->MiddleZ;
}

double RayView::GetDepthScale(const dvec3& half) const
{
  constexpr double margin = 1.01; // for rounding
  double largest = 0.0;
  for (int i = 0; i < 8; ++i)
  {
    largest = std::max(largest, std::abs(this->GetDepth(GetBoxCorner(half, i))));
  }
  return largest > 0.0 ? 1.0 / (margin * largest) : 1.0;
}

dvec3 RayView::GetBoxCorner(const dvec3& half, int i)
{
  return half * dvec3(i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, i & 4 ? 1.0 : -1.0);
}

// The plane is in clip coordinates.
bool RayView::AreCornersAbove(const dvec3& half, const dvec4& plane) const
{
  bool areAbove = true;
  for (int i = 0; i < 8; ++i)
  {
    areAbove = areAbove && dot(plane, this->MeshToClip * dvec4(GetBoxCorner(half, i), 1.0)) > 0.0;
  }
  return areAbove;
}

double RayView::GetLargestScale() const
{
  double matrix[3][3];
  double left[3][3];
  double right[3][3];
  double scales[3];
  for (int i = 0; i < 9; ++i)
  {
    matrix[i / 3][i % 3] = this->MeshToWorld[i / 3][i % 3];
  }
  vtkMath::SingularValueDecomposition3x3(matrix, left, scales, right);
  return std::max({ std::abs(scales[0]), std::abs(scales[1]), std::abs(scales[2]) });
}

bool RayView::IsTooLarge() const
{
  double largest = 0.0;
  for (int i = 0; i < 9; ++i)
  {
    largest = std::max(largest, std::abs(this->MeshToWorld[i / 3][i % 3]));
  }
  return largest > LargestLength;
}

// The rows are x and y in pixels, the distance along the ray (see relevoVolumeRay.glsl), and their
// weight.
void RayView::SetOutlineUniforms(vtkShaderProgram* program) const
{
  const dmat4 rows = transpose(this->MeshToClip) / this->MiddleWeight;
  const dvec4 weight = rows[3];
  SetMatrix(program, "meshToSeen",
    transpose(dmat4(0.5 * this->Viewport.z * (rows[0] + weight),
      0.5 * this->Viewport.w * (rows[1] + weight), rows[2] - this->MiddleZ * weight, weight)));
}

void RayView::SetUniforms(vtkShaderProgram* program) const
{
  SetVector(program, "rayMiddle", this->Middle);
  SetVector(program, "rayX", this->X);
  SetVector(program, "rayY", this->Y);
  SetVector(program, "rayZ", this->Z);
  SetVector(program, "viewportRectangle", this->Viewport);
  SetVector(program, "zRange", this->Range);
  SetMatrix(program, "meshToWorld", dmat3(this->MeshToWorld));
  SetMatrix(program, "gradientToWorld", this->GradientToWorld);
}
}
