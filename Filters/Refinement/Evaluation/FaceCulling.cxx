// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Evaluation/FaceCulling.h"

#include "Changes/Dependencies.h"
#include "Mathematics/RefinementMathematics.h"
#include "Mesh/ClosedSurface.h"
#include "Mesh/FaceBounds.h"
#include "Mesh/RefinementMesh.h"
#include "View/WorldView.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkCamera.h"
#include "vtkDisplacement.h"
#include "vtkLinearSurface.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkRefinementSurface.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>
#include <limits>

namespace relevo
{
#include "glsl/relevoCulling.glsl"

namespace
{
constexpr size_t Stride = 12; // floats per face

// As a share of the size of a mesh: boxes and planes are kept as floats.
constexpr double Tolerance = 1e-6;

vec3 Load(const float* v)
{
  return vec3(v[0], v[1], v[2]);
}

// The point (x, y, z, w) that lies on three planes: their cross product.
dvec4 Intersect(const dvec4& a, const dvec4& b, const dvec4& c)
{
  const auto minor = [&](int i, int j, int k)
  { return dot(dvec3(a[i], a[j], a[k]), cross(dvec3(b[i], b[j], b[k]), dvec3(c[i], c[j], c[k]))); };
  return dvec4(minor(1, 2, 3), -minor(0, 2, 3), minor(0, 1, 3), -minor(0, 1, 2));
}

dvec4 Normalize(const dvec4& plane)
{
  return plane / length(dvec3(plane));
}
}

CullingView::CullingView(vtkCamera* camera, double aspect, vtkMatrix4x4* modelToWorld,
  const RefinementMesh& mesh, const std::array<double, 2>& margins)
  : CullingView(camera, aspect, modelToWorld, mesh.Origin, margins)
{
}

CullingView::CullingView(vtkCamera* camera, double aspect, vtkMatrix4x4* modelToWorld,
  const double origin[3], const std::array<double, 2>& margins)
{
  dmat4 toWorld = MakeMatrix(modelToWorld);
  toWorld[3] = toWorld * dvec4(origin[0], origin[1], origin[2], 1.0);
  const dmat4 toClip =
    MakeMatrix(camera->GetCompositeProjectionTransformMatrix(aspect, -1.0, 1.0)) * toWorld;
  const dmat4 rows = transpose(toClip);
  const dvec4 right = rows[3] * (1.0 + margins[0]);
  const dvec4 upper = rows[3] * (1.0 + margins[1]);
  // Not the near and far planes: VTK may clamp depths. The last plane goes through the eye.
  const dvec4 planes[NumberOfPlanes] = { right + rows[0], right - rows[0], upper + rows[1],
    upper - rows[1], rows[3] };
  this->Parallel = dvec3(rows[3]) == dvec3(0.0);
  this->Valid = true;
  for (int i = 0; i < NumberOfPlanes; ++i)
  {
    const bool everything = this->Parallel && i == 4;
    const dvec4 plane = everything ? dvec4(0.0, 0.0, 0.0, 1.0) : Normalize(planes[i]);
    for (int c = 0; c < 4; ++c)
    {
      this->Planes[i][c] = static_cast<float>(plane[c]);
      this->Valid = this->Valid && std::isfinite(this->Planes[i][c]);
    }
  }
  const dvec4 nearest = Normalize(rows[3] + rows[2]);
  for (int c = 0; c < 4; ++c)
  {
    this->Near[c] = static_cast<float>(nearest[c]);
    this->Valid = this->Valid && std::isfinite(this->Near[c]);
  }

  // From the matrix, not from the camera's position: views may be sheared, transformed or stereo.
  const dvec4 point = Intersect(Normalize(planes[0]), Normalize(planes[2]),
    this->Parallel ? dvec4(0.0, 0.0, 0.0, 1.0) : Normalize(rows[3]));
  const dvec3 towardsEye = dvec3(point) * (dot(dvec3(rows[2]), dvec3(point)) < 0.0 ? 1.0 : -1.0);
  const dvec3 eye = this->Parallel ? towardsEye : dvec3(point) / point.w;
  for (int c = 0; c < 3; ++c)
  {
    this->Eye[c] = static_cast<float>(eye[c]);
    this->Valid = this->Valid && std::isfinite(this->Eye[c]);
  }
}

void CullingView::AddTo(Dependencies& dependencies) const
{
  std::for_each(this->Planes[0], this->Planes[0] + 4 * NumberOfPlanes,
    [&](float value) { dependencies.Add(value); });
  std::for_each(this->Eye, this->Eye + 3, [&](float value) { dependencies.Add(value); });
  dependencies.Add(this->Parallel);
  dependencies.Add(this->Valid);
}

void FaceCulling::Build(const RefinementMesh& mesh, vtkAdaptiveRefinement* recipe)
{
  this->Data.assign(Stride * mesh.Faces.size(), 0.0f);
  this->BuildBoxes(mesh, recipe);
  // How displaced faces are turned is not known.
  this->Closed = !recipe->GetDisplacement() && IsClosedOutwards(mesh);
  if (this->Closed)
  {
    this->BuildCones(mesh, recipe);
  }
}

void FaceCulling::BuildBoxes(const RefinementMesh& mesh, vtkAdaptiveRefinement* recipe)
{
  const FaceBounds bounds(mesh, recipe->GetSurface(), recipe->GetDisplacement());
  vtkSMPTools::For(0, static_cast<vtkIdType>(mesh.Faces.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType f = begin; f < end; ++f)
      {
        double low[3];
        double high[3];
        bounds.GetBox(static_cast<size_t>(f), low, high);
        float* data = &this->Data[Stride * static_cast<size_t>(f)];
        for (int c = 0; c < 3; ++c)
        {
          const double half =
            0.5 * (high[c] - low[c]) + Tolerance * std::max(std::abs(low[c]), std::abs(high[c]));
          data[c] = static_cast<float>(0.5 * (low[c] + high[c]));
          data[4 + c] = static_cast<float>(half);
        }
      }
    });
  std::fill_n(this->Low, 3, std::numeric_limits<float>::max());
  std::fill_n(this->High, 3, std::numeric_limits<float>::lowest());
  for (size_t i = 0; i < this->Data.size(); i += Stride)
  {
    for (size_t c = 0; c < 3; ++c)
    {
      this->Low[c] = std::min(this->Low[c], this->Data[i + c] - this->Data[i + 4 + c]);
      this->High[c] = std::max(this->High[c], this->Data[i + c] + this->Data[i + 4 + c]);
    }
  }
}

void FaceCulling::BuildCones(const RefinementMesh& mesh, vtkAdaptiveRefinement* recipe)
{
  vtkNew<vtkLinearSurface> linear;
  vtkRefinementSurface* surface = recipe->GetSurface() ? recipe->GetSurface() : linear.Get();
  const int edgePositions = surface->GetNumberOfEdgePositions();
  const int facePositions = surface->GetNumberOfFacePositions();
  vtkSMPTools::For(0, static_cast<vtkIdType>(mesh.Faces.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType f = begin; f < end; ++f)
      {
        const vtkRefinementSurface::Face face = mesh.GetSurfaceFace(static_cast<int>(f));
        float* data = &this->Data[Stride * static_cast<size_t>(f)];
        float* axis = data + 8;
        data[3] = surface->ComputeNormalCone(face, axis);
        if (mesh.Faces[f].IsTurned())
        {
          std::transform(axis, axis + 3, axis, std::negate<float>());
        }
        // How far points lie behind the middle, along any normal of the cone.
        const vec3 middle = Load(data);
        float reach = std::numeric_limits<float>::lowest();
        const auto extend = [&](const float* point)
        { reach = std::max(reach, dot(Load(axis), middle - Load(point))); };
        std::for_each(face.Points, face.Points + 3, extend);
        for (int e = 0; e < 3; ++e)
        {
          for (int k = 0; k < edgePositions; ++k)
          {
            extend(face.Vectors + 3 * (e * mesh.VectorsPerEdge + k));
          }
        }
        for (int k = 0; k < facePositions; ++k)
        {
          extend(face.Vectors + 3 * (3 * mesh.VectorsPerEdge + k));
        }
        const float radius = length(Load(data + 4));
        const float sine = std::sqrt(std::max(1.0f - data[3] * data[3], 0.0f));
        data[7] = reach + radius * (sine + static_cast<float>(Tolerance));
      }
    });
}

bool FaceCulling::IsUncut(const CullingView& view) const
{
  const vec3 middle = 0.5f * (Load(this->Low) + Load(this->High));
  const vec3 halfSides = 0.5f * (Load(this->High) - Load(this->Low));
  // The box lies wholly on the other side of the plane turned over.
  return isBoxBeyond(
    middle, halfSides, vec4(-view.Near[0], -view.Near[1], -view.Near[2], -view.Near[3]));
}

bool FaceCulling::HidesBackFaces(const CullingView& view, bool hideBackFaces) const
{
  return hideBackFaces && this->Closed && view.Valid && this->IsUncut(view);
}

int FaceCulling::FindHidden(
  const CullingView& view, bool hideBackFaces, std::vector<unsigned char>& hidden) const
{
  const size_t numberOfFaces = this->Data.size() / Stride;
  hidden.resize(numberOfFaces);
  if (!view.Valid)
  {
    std::fill(hidden.begin(), hidden.end(), static_cast<unsigned char>(0));
    return 0;
  }
  vec4 planes[CullingView::NumberOfPlanes];
  for (int i = 0; i < CullingView::NumberOfPlanes; ++i)
  {
    planes[i] = vec4(Load(view.Planes[i]), view.Planes[i][3]);
  }
  const vec3 eye = Load(view.Eye);
  const bool turned = this->HidesBackFaces(view, hideBackFaces);
  std::atomic<int> count(0);
  vtkSMPTools::For(0, static_cast<vtkIdType>(numberOfFaces),
    [&](vtkIdType begin, vtkIdType end)
    {
      int found = 0;
      for (vtkIdType f = begin; f < end; ++f)
      {
        const float* data = &this->Data[Stride * static_cast<size_t>(f)];
        const vec3 middle = Load(data);
        const vec3 halfSides = Load(data + 4);
        bool out = false;
        for (const vec4& plane : planes)
        {
          out = out || isBoxBeyond(middle, halfSides, plane);
        }
        if (!out && turned)
        {
          out = view.Parallel ? facesAway(Load(data + 8), data[3], eye, 0.0f)
                              : facesAway(Load(data + 8), data[3], eye - middle, data[7]);
        }
        hidden[f] = out ? 1 : 0;
        found += out ? 1 : 0;
      }
      count += found;
    });
  return count;
}
}
