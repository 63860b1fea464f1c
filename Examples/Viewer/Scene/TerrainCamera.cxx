// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/TerrainCamera.h"

#include "Scene/TerrainGround.h"

#include "vtkCamera.h"
#include "vtkMath.h"

#include <algorithm>
#include <cmath>

namespace
{
const double Margin = 0.02; // relative to the distance to the focal point
// The ground is sampled around the camera. Between samples it may be nearer.
const int Rings = 8;
const int Directions = 32;
const double Safety = 0.3;
}

//------------------------------------------------------------------------------
TerrainCamera::TerrainCamera(vtkRenderer* renderer, TerrainGround& ground)
  : ViewerCamera(renderer)
  , Ground(ground)
{
}

//------------------------------------------------------------------------------
bool TerrainCamera::IsClear(const double position[3], double margin)
{
  double ground;
  return !this->Ground.GetHighestGround(position[0], position[1], 0.0, ground) ||
    position[2] >= ground + margin;
}

//------------------------------------------------------------------------------
bool TerrainCamera::TurnUp(const double focus[3], double position[3], double margin)
{
  const double highest = vtkMath::RadiansFromDegrees(89.0);
  const double step = vtkMath::RadiansFromDegrees(0.25);
  const double offset[3] = { position[0] - focus[0], position[1] - focus[1],
    position[2] - focus[2] };
  const double distance = vtkMath::Norm(offset);
  const double azimuth = std::atan2(offset[1], offset[0]);
  double elevation = std::atan2(offset[2], std::hypot(offset[0], offset[1]));
  while (elevation < highest)
  {
    elevation = std::min(elevation + step, highest);
    position[0] = focus[0] + distance * std::cos(elevation) * std::cos(azimuth);
    position[1] = focus[1] + distance * std::cos(elevation) * std::sin(azimuth);
    position[2] = focus[2] + distance * std::sin(elevation);
    if (this->IsClear(position, margin))
    {
      return true;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
void TerrainCamera::MoveOut(vtkCamera* camera)
{
  double position[3];
  double focus[3];
  camera->GetPosition(position);
  camera->GetFocalPoint(focus);
  const double margin = Margin * camera->GetDistance();
  if (this->StaysInPlace || this->IsClear(position, margin))
  {
    return;
  }
  double turned[3] = { position[0], position[1], position[2] };
  if (!this->TurnUp(focus, turned, margin))
  {
    // The focal point is below the ground.
    std::copy_n(position, 3, turned);
    this->Ground.GetHighestGround(turned[0], turned[1], 0.0, turned[2]);
    turned[2] += margin;
  }
  camera->SetPosition(turned);
}

//------------------------------------------------------------------------------
double TerrainCamera::GetMinimumDistance(vtkCamera* camera)
{
  double position[3];
  camera->GetPosition(position);
  double nearest[2] = { position[0], position[1] };
  this->Ground.MoveOnto(nearest);
  double least = camera->GetDistance();
  const auto measure = [&](double x, double y, double spacing)
  {
    double ground;
    if (this->Ground.GetHighestGround(x, y, spacing, ground))
    {
      // Ground above the camera may be lower.
      const double point[3] = { x, y, std::min(ground, position[2]) };
      least = std::min(least, std::sqrt(vtkMath::Distance2BetweenPoints(point, position)));
    }
  };
  measure(nearest[0], nearest[1], 0.0);
  // Points nearer than this distance are not farther to the side either.
  const double reach = least;
  for (int i = 0; i < Rings * Directions; ++i)
  {
    const double radius = reach * (1 + i / Directions) / Rings;
    const double angle = 2.0 * vtkMath::Pi() * (i % Directions) / Directions;
    measure(position[0] + radius * std::cos(angle), position[1] + radius * std::sin(angle),
      reach / Rings);
  }
  return Safety * least;
}
