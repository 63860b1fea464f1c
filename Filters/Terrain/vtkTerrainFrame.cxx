// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerrainFrame.h"

#include <GeographicLib/Geocentric.hpp>
#include <GeographicLib/LocalCartesian.hpp>

#include <algorithm>
#include <cmath>

namespace relevo
{
namespace
{
constexpr double CosineOfHorizon = 0.1;

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
  const std::array<double, 2> coordinates = this->Location.Coordinates(u, v);
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
}
