// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Bisection/TerrainView.h"

#include "Bisection/GlobeView.h"
#include "View/RefinementView.h"
#include "View/WorldView.h"
#include "vtkCamera.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace relevo
{
void TerrainView::SetCamera(vtkCamera* camera, const int viewport[2])
{
  RefinementView pixels;
  pixels.Camera = camera;
  std::copy_n(viewport, 2, pixels.ViewportSize);
  std::array<double, 3> eye;
  std::array<double, 3> direction;
  camera->GetPosition(eye.data());
  camera->GetDirectionOfProjection(direction.data());
  double planes[24];
  camera->GetFrustumPlanes(static_cast<double>(viewport[0]) / viewport[1], planes);
  std::array<std::array<double, 4>, 6> frustum{};
  for (int i = 0; i < 4; ++i)
  {
    std::copy_n(planes + 4 * i, 4, frustum[i].begin());
  }
  frustum[5] = { { 0.0, 0.0, 0.0, 1.0 } };
  if (camera->GetParallelProjection())
  {
    frustum[4] = frustum[5];
    this->SetParallel(viewport[1] / (2.0 * camera->GetParallelScale()));
  }
  else
  {
    // Nothing behind the eye.
    frustum[4] = { { direction[0], direction[1], direction[2],
      -(direction[0] * eye[0] + direction[1] * eye[1] + direction[2] * eye[2]) } };
    this->SetPerspective(eye, GetPixelsAtUnitDistance(pixels), camera->GetClippingRange()[0]);
  }
  this->SetFrustum(frustum);
}

void TerrainView::SetPerspective(
  const std::array<double, 3>& eye, double pixelsPerUnit, double nearestDistance)
{
  this->IsParallel = false;
  this->Eye = eye;
  this->PixelsPerUnit = pixelsPerUnit;
  this->NearestDistance = nearestDistance;
  this->SetPlacement(this->Placement);
}

void TerrainView::SetParallel(double pixelsPerUnit)
{
  this->IsParallel = true;
  this->PixelsPerUnit = pixelsPerUnit;
}

void TerrainView::SetFrustum(const std::array<std::array<double, 4>, 6>& planes)
{
  this->Planes = planes;
  this->HasPlanes = true;
}

void TerrainView::SetPlacement(const TerrainPlacement& placement)
{
  this->Placement = placement;
  if (placement.Globe)
  {
    this->Globe = std::make_shared<GlobeView>(placement, this->Eye);
    return;
  }
  const auto& column = placement.Column;
  const auto& row = placement.Row;
  const double determinant = column[0] * row[1] - column[1] * row[0];
  const double x = this->Eye[0] - placement.Origin[0];
  const double y = this->Eye[1] - placement.Origin[1];
  this->RasterEye = { { (x * row[1] - y * row[0]) / determinant,
    (column[0] * y - column[1] * x) / determinant } };
  // In sheared rasters, distances are at least those along the shorter principal axis.
  const double a = column[0] * column[0] + column[1] * column[1];
  const double b = column[0] * row[0] + column[1] * row[1];
  const double c = row[0] * row[0] + row[1] * row[1];
  const bool isSheared = std::abs(b) > 1e-9 * std::sqrt(a * c);
  const double shorter = std::sqrt(std::max(0.0, (a + c - std::hypot(a - c, 2.0 * b)) / 2.0));
  this->Lengths = { { isSheared ? shorter : std::sqrt(a), isSheared ? shorter : std::sqrt(c) } };
}

bool TerrainView::IsVisible(const TerrainBox& box) const
{
  if (this->Globe)
  {
    return this->Globe->IsVisible(box, this->HasPlanes ? &this->Planes : nullptr,
      this->HasPlanes && this->HasHorizon && !this->IsParallel);
  }
  if (!this->HasPlanes)
  {
    return true;
  }
  std::array<std::array<double, 3>, 8> corners;
  for (int i = 0; i < 8; ++i)
  {
    corners[i] = this->Placement.ToWorld(
      box.Columns[i & 1], box.Rows[(i >> 1) & 1], box.Heights[(i >> 2) & 1]);
  }
  return std::all_of(this->Planes.begin(), this->Planes.end(),
    [&corners](const std::array<double, 4>& plane)
    {
      return std::any_of(corners.begin(), corners.end(),
        [&plane](const std::array<double, 3>& p)
        { return plane[0] * p[0] + plane[1] * p[1] + plane[2] * p[2] + plane[3] >= 0.0; });
    });
}

double TerrainView::GetShapeError(int level, bool isSquare, const TerrainBox& box) const
{
  return this->Globe ? this->Globe->GetShapeError(level, isSquare, box) : 0.0;
}

double TerrainView::Project(double distance, const TerrainBox& box) const
{
  return this->ProjectLength(distance * std::abs(this->Placement.HeightScale), box);
}

double TerrainView::ProjectLength(double length, const TerrainBox& box) const
{
  const double pixels = length * this->PixelsPerUnit;
  if (!(pixels > 0.0) || box.Heights[0] > box.Heights[1])
  {
    return 0.0;
  }
  if (this->IsParallel)
  {
    return pixels;
  }
  if (this->Globe)
  {
    const double distanceOfEye = std::max(this->NearestDistance, this->Globe->GetDistance(box));
    return distanceOfEye > 0.0 ? pixels / distanceOfEye : std::numeric_limits<double>::infinity();
  }
  const auto outside = [](double x, const std::array<double, 2>& range) {
    return std::max({ range[0] - x, x - range[1], 0.0 });
  };
  const double scale = this->Placement.HeightScale;
  std::array<double, 2> heights = { { box.Heights[0] * scale, box.Heights[1] * scale } };
  std::sort(heights.begin(), heights.end());
  const double x = outside(this->RasterEye[0], box.Columns) * this->Lengths[0];
  const double y = outside(this->RasterEye[1], box.Rows) * this->Lengths[1];
  const double z = outside(this->Eye[2], heights);
  const double eyeDistance = std::max(this->NearestDistance, std::sqrt(x * x + y * y + z * z));
  return eyeDistance > 0.0 ? pixels / eyeDistance : std::numeric_limits<double>::infinity();
}
}
