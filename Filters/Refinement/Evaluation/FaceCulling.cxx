// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Evaluation/FaceCulling.h"

#include "Mathematics/RefinementMathematics.h"
#include "Mesh/ClosedSurface.h"
#include "Mesh/FaceBounds.h"
#include "Mesh/RefinementMesh.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkDisplacement.h"
#include "vtkLinearSurface.h"
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

// Relative to the size of a mesh, because boxes and planes are stored as floats.
constexpr double Tolerance = 1e-6;

vec3 Load(const float* v)
{
  return vec3(v[0], v[1], v[2]);
}
}

void FaceCulling::Build(const RefinementMesh& mesh, vtkAdaptiveRefinement* recipe)
{
  this->Data.assign(Stride * mesh.Faces.size(), 0.0f);
  this->BuildBoxes(mesh, recipe);
  // The orientation of displaced faces is not known.
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
        // The reach is the largest distance of points behind the centre along any normal of the
        // cone.
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
  // The box must be completely on the other side of the reversed plane.
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
