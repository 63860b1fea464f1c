// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "View/TerrainViewpoint.h"

#include "Actors/ActorView.h"
#include "Changes/Dependencies.h"
#include "View/CameraEye.h"
#include "View/WorldView.h"
#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace relevo
{
TerrainViewpoint::TerrainViewpoint(vtkRenderer* renderer, vtkActor* actor)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  const dmat4 toWorld = MakeMatrix(actor->GetMatrix());
  vtkNew<vtkMatrix4x4> toModel;
  toModel->DeepCopy(actor->GetMatrix());
  toModel->Invert();
  const dvec4 eye = GetEye(camera, toModel);
  this->IsParallel = eye.w == 0.0;
  dvec4 nearPoint = eye;
  if (this->IsParallel)
  {
    const double* focalPoint = camera->GetFocalPoint();
    nearPoint = MakeMatrix(toModel) * dvec4(focalPoint[0], focalPoint[1], focalPoint[2], 1.0);
  }
  // With an actor that is scaled differently along its axes, the error is estimated upwards.
  const double scales[3] = { length(dvec3(toWorld[0])), length(dvec3(toWorld[1])),
    length(dvec3(toWorld[2])) };
  const double largest = *std::max_element(scales, scales + 3);
  const double smallest = *std::min_element(scales, scales + 3);
  const RefinementView view = MakeActorView(renderer, actor);
  this->PixelsPerUnit = this->IsParallel
    ? largest * view.ViewportSize[1] / (2.0 * camera->GetParallelScale())
    : largest / smallest * GetPixelsAtUnitDistance(view);
  this->HalfViewport = { { 0.5 * view.ViewportSize[0], 0.5 * view.ViewportSize[1] } };
  this->NearestDistance = std::max(0.0, camera->GetClippingRange()[0] / largest);
  const dmat4 rows = transpose(MakeMatrix(camera->GetCompositeProjectionTransformMatrix(
                                 renderer->GetTiledAspectRatio(), -1.0, 1.0)) *
    toWorld);
  this->Valid = std::isfinite(this->PixelsPerUnit) && this->PixelsPerUnit > 0.0;
  for (int i = 0; i < 6; ++i)
  {
    const dvec4 plane = rows[3] + (i % 2 == 0 ? rows[i / 2] : -rows[i / 2]);
    for (int c = 0; c < 4; ++c)
    {
      this->Planes[i][c] = plane[c];
      this->Valid = this->Valid && std::isfinite(plane[c]);
    }
  }
  for (int c = 0; c < 3; ++c)
  {
    this->NearPoint[c] = nearPoint[c] / nearPoint.w;
    this->Valid = this->Valid && std::isfinite(this->NearPoint[c]);
  }
  this->IsCulled = !MovesVertices(actor);
  this->IsTranslucent = actor->HasTranslucentPolygonalGeometry() != 0;
}

void TerrainViewpoint::AddTo(Dependencies& dependencies) const
{
  dependencies.Add(this->IsParallel);
  dependencies.Add(this->IsCulled);
  dependencies.Add(this->IsTranslucent);
  dependencies.Add(this->PixelsPerUnit);
  dependencies.Add(this->NearestDistance);
  for (double coordinate : this->NearPoint)
  {
    dependencies.Add(coordinate);
  }
  for (const auto& plane : this->Planes)
  {
    for (double number : plane)
    {
      dependencies.Add(number);
    }
  }
}

TerrainView TerrainViewpoint::MakeView(const TerrainPlacement& placement) const
{
  TerrainView view;
  if (this->IsParallel)
  {
    view.SetParallel(this->PixelsPerUnit);
  }
  else
  {
    view.SetPerspective(this->NearPoint, this->PixelsPerUnit, this->NearestDistance);
  }
  if (this->IsCulled)
  {
    view.SetFrustum(this->Planes);
    view.SetHorizon(!this->IsTranslucent);
  }
  view.SetPlacement(placement);
  return view;
}

// The planes of the frustum are the coordinates that OpenGL clips by, w + x, w - x, w + y and so
// on.
double TerrainViewpoint::GetLongestSide(const std::array<std::array<double, 3>, 3>& corners) const
{
  std::array<dvec2, 3> pixels;
  for (int i = 0; i < 3; ++i)
  {
    const dvec4 corner(corners[i][0], corners[i][1], corners[i][2], 1.0);
    const auto clip = [this, &corner](int plane)
    {
      const auto& numbers = this->Planes[plane];
      return dot(dvec4(numbers[0], numbers[1], numbers[2], numbers[3]), corner);
    };
    const double left = clip(0);
    const double right = clip(1);
    const double bottom = clip(2);
    const double top = clip(3);
    const double w = 0.5 * (left + right);
    if (!(w > 0.0))
    {
      return std::numeric_limits<double>::infinity();
    }
    pixels[i] =
      dvec2(this->HalfViewport[0] * (left - right), this->HalfViewport[1] * (bottom - top)) /
      (2.0 * w);
  }
  double longest = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    longest = std::max(longest, length(pixels[i] - pixels[(i + 1) % 3]));
  }
  return longest;
}
}
