// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/GlobeCamera.h"

#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkTerrainMapper.h"
#include "vtkTerrainPyramid.h"

#include <algorithm>
#include <cmath>

namespace
{
const double GroundMargin = 0.02; // relative to the distance to the focal point
// Slopes around the camera are nearer than the ground below it.
const double GroundSafety = 0.2;
}

//------------------------------------------------------------------------------
GlobeCamera::GlobeCamera(vtkRenderer* renderer, vtkTerrainMapper* mapper)
  : ViewerCamera(renderer)
  , Mapper(mapper)
{
}

//------------------------------------------------------------------------------
GlobeCamera::~GlobeCamera() = default;

//------------------------------------------------------------------------------
bool GlobeCamera::FindGround(const Point& point, Point& ground, double& height)
{
  double raster[3];
  if (!this->Mapper->WorldToRaster(point.data(), raster))
  {
    return false;
  }
  const double above = raster[2];
  raster[2] = this->Mapper->GetPyramid()->GetElevation(raster[0], raster[1]);
  height = (above - raster[2]) * this->Mapper->GetPyramid()->GetVerticalUnit() *
    this->Mapper->GetExaggeration();
  return std::isfinite(raster[2]) && this->Mapper->RasterToWorld(raster, ground.data());
}

//------------------------------------------------------------------------------
GlobeCamera::Point GlobeCamera::FindUp(const Point& point)
{
  double geographic[3];
  Point higher = point;
  if (this->Mapper->WorldToGeographic(point.data(), geographic))
  {
    geographic[2] += 1.0;
    this->Mapper->GeographicToWorld(geographic, higher.data());
  }
  Point up;
  vtkMath::Subtract(higher.data(), point.data(), up.data());
  if (!(vtkMath::Normalize(up.data()) > 0.0))
  {
    up = point;
    vtkMath::Normalize(up.data());
  }
  return up;
}

//------------------------------------------------------------------------------
void GlobeCamera::MoveOut(vtkCamera* camera)
{
  Point position;
  Point focus;
  camera->GetPosition(position.data());
  camera->GetFocalPoint(focus.data());
  const double distance = camera->GetDistance();
  const double margin = GroundMargin * distance;
  Point ground;
  double height = 0.0;
  const auto isClear = [&](const Point& place)
  { return !this->FindGround(place, ground, height) || height >= margin; };
  if (this->StaysInPlace || isClear(position))
  {
    return;
  }
  const Point up = this->FindUp(focus);
  Point offset;
  vtkMath::Subtract(position.data(), focus.data(), offset.data());
  const double rise = vtkMath::Dot(offset.data(), up.data());
  Point across;
  for (int i = 0; i < 3; ++i)
  {
    across[i] = offset[i] - rise * up[i];
  }
  const double width = vtkMath::Normalize(across.data());
  const double highest = vtkMath::RadiansFromDegrees(89.0);
  const double step = vtkMath::RadiansFromDegrees(0.25);
  double elevation = std::atan2(rise, width);
  while (elevation < highest)
  {
    elevation = std::min(elevation + step, highest);
    for (int i = 0; i < 3; ++i)
    {
      position[i] =
        focus[i] + distance * (std::cos(elevation) * across[i] + std::sin(elevation) * up[i]);
    }
    if (isClear(position))
    {
      camera->SetPosition(position.data());
      return;
    }
  }
  // The focal point is below the ground.
  for (int i = 0; i < 3; ++i)
  {
    position[i] = ground[i] + margin * up[i];
  }
  camera->SetPosition(position.data());
}

//------------------------------------------------------------------------------
double GlobeCamera::GetMinimumDistance(vtkCamera* camera)
{
  Point position;
  camera->GetPosition(position.data());
  Point ground;
  double height;
  const double least = ViewerCamera::GetMinimumDistance(camera);
  return this->FindGround(position, ground, height)
    ? std::min(least, GroundSafety * std::abs(height))
    : least;
}
