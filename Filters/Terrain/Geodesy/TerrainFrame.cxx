// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Geodesy/TerrainFrame.h"

#include "Geodesy/TangentPlane.h"
#if RELEVO_HAS_GDAL
#include "Geodesy/CoordinateSystem.h"
#endif

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <sstream>

namespace relevo
{
TerrainFrame::TerrainFrame(const Georeference& location)
  : Location(location)
  , Center(location.Coordinates(0.5, 0.5))
{
  if (location.System == Georeference::Kind::Geographic)
  {
    this->Plane = std::make_unique<TangentPlane>(location, this->Center);
  }
}

TerrainFrame::~TerrainFrame() = default;

bool TerrainFrame::Place(double u, double v, std::array<double, 2>& place) const
{
  return this->ToPlace(this->Location.Coordinates(u, v), place);
}

bool TerrainFrame::ToParameters(const std::array<double, 2>& place, std::array<double, 2>& uv) const
{
  std::array<double, 2> coordinates;
  if (!this->ToCoordinates(place, coordinates))
  {
    return false;
  }
  uv = this->Location.Parameters(coordinates);
  return true;
}

bool TerrainFrame::IsWithinHorizon() const
{
  constexpr int samples = 64; // intervals along each side
  for (int i = 0; this->Plane && i <= samples; ++i)
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

std::array<double, 2> TerrainFrame::GetLengths() const
{
  // Around a pole both ends of a parallel coincide, so that lengths are summed over parts of it.
  const int parts = this->Plane ? 64 : 1;
  const auto measure = [this, parts](int axis)
  {
    double length = 0.0;
    std::array<double, 2> ends[2];
    for (int i = 0; i <= parts; ++i)
    {
      const double along = static_cast<double>(i) / parts;
      this->Place(axis == 0 ? along : 0.5, axis == 0 ? 0.5 : along, ends[i % 2]);
      length += i > 0 ? std::hypot(ends[1][0] - ends[0][0], ends[1][1] - ends[0][1]) : 0.0;
    }
    return length;
  };
  return { measure(0), measure(1) };
}

bool TerrainFrame::FitsMesh() const
{
  constexpr double largest = std::numeric_limits<float>::max();
  const auto fits = [](const std::array<double, 2>& values)
  { return std::abs(values[0]) <= largest && std::abs(values[1]) <= largest; }; // false for NaN
  for (int corner = 0; corner < 4; ++corner)
  {
    std::array<double, 2> place;
    this->Place(corner % 2, corner / 2, place);
    if (!fits(place))
    {
      return false;
    }
  }
  const std::array<double, 2> lengths = this->GetLengths();
  return fits(lengths) && std::max(lengths[0], lengths[1]) > 0.0;
}

bool TerrainFrame::ToPlace(
  const std::array<double, 2>& coordinates, std::array<double, 2>& place) const
{
  const double unit = this->Location.Unit;
  if (this->Plane)
  {
    return this->Plane->FromEllipsoid(coordinates[0] * unit, coordinates[1] * unit, place);
  }
  place = { (coordinates[0] - this->Center[0]) * unit, (coordinates[1] - this->Center[1]) * unit };
  return true;
}

bool TerrainFrame::ToCoordinates(
  const std::array<double, 2>& place, std::array<double, 2>& coordinates) const
{
  const double unit = this->Location.Unit;
  if (!this->Plane)
  {
    coordinates = { this->Center[0] + place[0] / unit, this->Center[1] + place[1] / unit };
    return true;
  }
  double longitude;
  double latitude;
  std::array<double, 9> rotation;
  if (!this->Plane->ToEllipsoid(place, longitude, latitude, rotation))
  {
    return false;
  }
  // Some rasters use longitudes from 0 to 360.
  const double center = this->Center[0] * unit;
  longitude += 360.0 * std::round((center - longitude) / 360.0);
  coordinates = { longitude / unit, latitude / unit };
  return true;
}

namespace
{
// Whether coordinates are those of the whole globe in degrees, up to a sample.
bool CoversGlobe(const Georeference& location, const int texels[2])
{
  constexpr double longitudes = 360.0;
  constexpr double latitudes = 180.0;
  constexpr double largestSample = 15.0;
  const std::array<double, 2> first = location.Coordinates(0, 0);
  const std::array<double, 2> last = location.Coordinates(1, 1);
  const double width = std::abs(last[0] - first[0]);
  const double height = std::abs(last[1] - first[1]);
  const double column = width / texels[0];
  const double row = height / texels[1];
  return std::max(column, row) <= largestSample && std::abs(width - longitudes) <= column &&
    std::abs(height - latitudes) <= row && std::abs(first[1] + last[1]) <= row &&
    std::max(std::abs(first[0]), std::abs(last[0])) <= longitudes + column;
}
}

bool LooksGeographic(const Georeference& location, const int texels[2])
{
  if (location.System != Georeference::Kind::Planar || !location.WKT.empty())
  {
    return false;
  }
  if (CoversGlobe(location, texels))
  {
    return true;
  }
  for (int corner = 0; corner < 4; ++corner)
  {
    const std::array<double, 2> place = location.Coordinates(corner % 2, corner / 2);
    if (std::abs(place[0]) > 360.0 || std::abs(place[1]) > 90.0)
    {
      return false;
    }
  }
  return std::hypot(location.AlongU[0], location.AlongU[1]) < texels[0] &&
    std::hypot(location.AlongV[0], location.AlongV[1]) < texels[1];
}

std::string FindLocationWarning(const Georeference& location, const int texels[2])
{
  if (LooksGeographic(location, texels))
  {
    return " has no coordinate system, so its coordinates are taken as metres. They look like "
           "degrees: if they are, declare them (gdal_translate -a_srs EPSG:4326).";
  }
#if RELEVO_HAS_GDAL
  constexpr double largestDeviation = 0.05;
  double scale = 1.0;
  if (location.System == Georeference::Kind::Planar && !location.WKT.empty() &&
    FindScale(location, scale) && std::abs(scale - 1.0) > largestDeviation)
  {
    std::ostringstream text;
    text << ": its projection scales lengths at its centre by " << std::setprecision(3) << scale
         << ", but not heights. Reproject it, for example to UTM (gdalwarp -t_srs).";
    return text.str();
  }
#endif
  return "";
}

std::string FindSystemError(const Georeference& location)
{
  if (location.System == Georeference::Kind::Unsupported)
  {
    return " is neither in longitude and latitude nor in a projection: project it first "
           "(gdalwarp -t_srs).";
  }
  if (location.System == Georeference::Kind::NoEllipsoid)
  {
    return " has an ellipsoid that is not supported: the flattening must be less than 1. Give the "
           "file the right coordinate system (gdal_translate -a_srs).";
  }
  return "";
}

std::string FindLocationError(const Georeference& location)
{
  const std::string error = FindSystemError(location);
  if (!error.empty())
  {
    return error;
  }
  const TerrainFrame frame(location);
  if (!frame.FitsMesh())
  {
    // Declared as longitude and latitude, but in metres.
    const double latitude = frame.GetCenter()[1] * location.Unit;
    if (location.System == Georeference::Kind::Geographic && std::abs(latitude) > 90.0)
    {
      return " has latitudes beyond the poles, so its coordinate system does not fit its "
             "coordinates. Give it the right one (gdal_translate -a_srs).";
    }
    return " has an invalid georeference: its corners coincide, or are out of the range of floats. "
           "Give the file the right georeference (gdal_edit.py -a_ullr).";
  }
  if (!frame.IsWithinHorizon())
  {
    return " reaches beyond the horizon of its centre, where a tangent plane cannot map the earth; "
           "project it first (gdalwarp -t_srs), or crop it to less than 80 degrees around the "
           "centre.";
  }
  return "";
}
}
