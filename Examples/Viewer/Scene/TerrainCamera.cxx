// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/TerrainCamera.h"

#include "Scene/TerrainProbe.h"

#include "vtkCamera.h"
#include "vtkDisplacement.h"
#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace
{
const double Margin = 0.02; // relative to the distance to the focal point
// The ground is sampled around the camera. Between samples it may be nearer.
const int Rings = 8;
const int Directions = 32;
const double Safety = 0.3;
}

//------------------------------------------------------------------------------
TerrainCamera::TerrainCamera(vtkRenderer* renderer, TerrainProbe& probe,
  vtkDisplacement* displacement, int lowestLevel, int highestLevel)
  : ViewerCamera(renderer)
  , Probe(probe)
  , Displacement(displacement)
  , LowestLevel(lowestLevel)
  , HighestLevel(highestLevel)
{
}

//------------------------------------------------------------------------------
bool TerrainCamera::GetGround(double x, double y, double& z)
{
  const std::vector<double> heights =
    this->Probe.GetDrawnHeights(x, y, this->LowestLevel, this->HighestLevel);
  z = -std::numeric_limits<double>::infinity();
  for (double height : heights)
  {
    z = std::max(z, this->Displacement->GetOffset() + this->Displacement->GetScale() * height);
  }
  return !heights.empty();
}

//------------------------------------------------------------------------------
bool TerrainCamera::IsClear(const double position[3], double margin)
{
  double ground;
  return !this->GetGround(position[0], position[1], ground) || position[2] >= ground + margin;
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
  if (this->IsClear(position, margin))
  {
    return;
  }
  double turned[3] = { position[0], position[1], position[2] };
  if (!this->TurnUp(focus, turned, margin))
  {
    // The focal point is below the ground.
    std::copy_n(position, 3, turned);
    this->GetGround(turned[0], turned[1], turned[2]);
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
  this->Probe.MoveOnto(nearest);
  double least = camera->GetDistance();
  const auto measure = [&](double x, double y)
  {
    double ground;
    if (this->GetGround(x, y, ground))
    {
      const double point[3] = { x, y, ground };
      least = std::min(least, std::sqrt(vtkMath::Distance2BetweenPoints(point, position)));
    }
  };
  measure(nearest[0], nearest[1]);
  // Points nearer than this distance are not farther to the side either.
  const double reach = least;
  for (int i = 0; i < Rings * Directions; ++i)
  {
    const double radius = reach * (1 + i / Directions) / Rings;
    const double angle = 2.0 * vtkMath::Pi() * (i % Directions) / Directions;
    measure(position[0] + radius * std::cos(angle), position[1] + radius * std::sin(angle));
  }
  return Safety * least;
}
