// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Geodesy/TerrainFrame.h"

#include <GeographicLib/Geocentric.hpp>
#include <GeographicLib/LocalCartesian.hpp>

#include <algorithm>
#include <cmath>

namespace relevo
{
namespace
{
constexpr double CosineOfHorizon = 0.1;

// Limits of the search for the point of the ellipsoid below a point of the plane.
constexpr int MaximumNumberOfSteps = 20;
constexpr double SearchTolerance = 1e-7; // metres

// Rasters of points reach half a texel beyond the poles.
double latitude(double degrees)
{
  return std::clamp(degrees, -90.0, 90.0);
}

double cosineOfAngle(double longitude, double latitude0, double latitude1)
{
  const double radians = M_PI / 180.0;
  return std::sin(latitude0 * radians) * std::sin(latitude1 * radians) +
    std::cos(latitude0 * radians) * std::cos(latitude1 * radians) * std::cos(longitude * radians);
}
}

struct TerrainFrame::Tangent
{
  GeographicLib::LocalCartesian Frame;
};

TerrainFrame::TerrainFrame(const Georeference& location)
  : Location(location)
  , Center(location.Coordinates(0.5, 0.5))
{
  if (location.System == Georeference::Kind::Geographic)
  {
    const GeographicLib::Geocentric earth(location.SemiMajorAxis, location.Flattening);
    this->Frame.reset(new Tangent{ GeographicLib::LocalCartesian(
      latitude(this->Center[1] * location.Unit), this->Center[0] * location.Unit, 0.0, earth) });
  }
}

TerrainFrame::~TerrainFrame() = default;

bool TerrainFrame::Place(double u, double v, std::array<double, 2>& place) const
{
  return this->ToPlace(this->Location.Coordinates(u, v), place);
}

bool TerrainFrame::IsWithinHorizon() const
{
  constexpr int samples = 64; // along each side, after the first
  for (int i = 0; this->Frame && i <= samples; ++i)
  {
    for (int j = 0; j <= samples; ++j)
    {
      std::array<double, 2> place;
      if (!this->Place(static_cast<double>(i) / samples, static_cast<double>(j) / samples, place))
      {
        return false;
      }
    }
  }
  return true;
}

bool TerrainFrame::ToPlace(
  const std::array<double, 2>& coordinates, std::array<double, 2>& place) const
{
  const double unit = this->Location.Unit;
  if (!this->Frame)
  {
    place = { (coordinates[0] - this->Center[0]) * unit,
      (coordinates[1] - this->Center[1]) * unit };
    return true;
  }
  const double longitude = coordinates[0] * unit;
  const double north = latitude(coordinates[1] * unit);
  double drop; // of the ellipsoid below the tangent plane: heights count from the ellipsoid
  this->Frame->Frame.Forward(north, longitude, 0.0, place[0], place[1], drop);
  return cosineOfAngle(longitude - this->Frame->Frame.LongitudeOrigin(),
           this->Frame->Frame.LatitudeOrigin(), north) > CosineOfHorizon;
}

bool TerrainFrame::ToCoordinates(
  const std::array<double, 2>& place, std::array<double, 2>& coordinates) const
{
  const double unit = this->Location.Unit;
  if (!this->Frame)
  {
    coordinates = { this->Center[0] + place[0] / unit, this->Center[1] + place[1] / unit };
    return true;
  }
  // Newton's method down the vertical, from the tangent plane to the ellipsoid. The height above
  // the ellipsoid is a convex function there, so that no step goes too far.
  const GeographicLib::LocalCartesian& frame = this->Frame->Frame;
  double drop = 0.0;
  for (int step = 0; step < MaximumNumberOfSteps; ++step)
  {
    double north;
    double longitude;
    double height;
    frame.Reverse(place[0], place[1], drop, north, longitude, height);
    const double cosine =
      cosineOfAngle(longitude - frame.LongitudeOrigin(), frame.LatitudeOrigin(), north);
    if (!(cosine > CosineOfHorizon))
    {
      return false;
    }
    if (std::abs(height) < SearchTolerance)
    {
      // Some rasters count longitude from 0 to 360.
      const double center = this->Center[0] * unit;
      longitude += 360.0 * std::round((center - longitude) / 360.0);
      coordinates = { longitude / unit, north / unit };
      return true;
    }
    drop -= height / cosine;
  }
  return false;
}
}
