// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Geodesy/TangentPlane.h"

#include "Geodesy/Georeference.h"

#include <GeographicLib/Geocentric.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace relevo
{
namespace
{
// The cosine of the angle between the vertical at a position and that of the plane is an element of
// the rotation.
constexpr double CosineOfHorizon = 0.1;
constexpr int CosineElement = 8;

// Limits of the search for the point of the ellipsoid below a position.
constexpr int MaximumNumberOfSteps = 20;
constexpr double SearchTolerance = 1e-7; // metres

double withinPoles(double latitude)
{
  return std::clamp(latitude, -90.0, 90.0);
}
}

TangentPlane::TangentPlane(const Georeference& system, const std::array<double, 2>& place)
  : Frame(withinPoles(place[1] * system.Unit), place[0] * system.Unit, 0.0,
      GeographicLib::Geocentric(system.SemiMajorAxis, system.Flattening))
{
}

bool TangentPlane::FromEllipsoid(
  double longitude, double latitude, std::array<double, 2>& place) const
{
  double drop; // drop of the ellipsoid below the plane, which heights ignore
  std::vector<double> rotation(9);
  this->Frame.Forward(withinPoles(latitude), longitude, 0.0, place[0], place[1], drop, rotation);
  return rotation[CosineElement] > CosineOfHorizon;
}

bool TangentPlane::ToEllipsoid(const std::array<double, 2>& place, double& longitude,
  double& latitude, std::array<double, 9>& rotation) const
{
  // Newton's method along the vertical of the plane. The height above the ellipsoid is a convex
  // function of the drop, and its slope is the cosine, so that the steps do not overshoot.
  double drop = 0.0;
  std::vector<double> turned(rotation.size());
  for (int step = 0; step < MaximumNumberOfSteps; ++step)
  {
    double height;
    this->Frame.Reverse(place[0], place[1], drop, latitude, longitude, height, turned);
    const double cosine = turned[CosineElement];
    if (!(cosine > CosineOfHorizon))
    {
      return false;
    }
    if (std::abs(height) < SearchTolerance)
    {
      std::copy(turned.begin(), turned.end(), rotation.begin());
      return true;
    }
    drop -= height / cosine;
  }
  return false;
}
}
