// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Geodesy/CoordinateSystem.h"

#include "Geodesy/GDALSession.h"

#include <cmath>
#include <limits>

namespace relevo
{
SpatialReference NewSpatialReference(const std::string& definition)
{
  SpatialReference system(OSRNewSpatialReference(nullptr));
  if (!system || OSRSetFromUserInput(system.get(), definition.c_str()) != OGRERR_NONE)
  {
    return nullptr;
  }
  OSRSetAxisMappingStrategy(system.get(), OAMS_TRADITIONAL_GIS_ORDER);
  return system;
}

void DescribeCoordinateSystem(OGRSpatialReferenceH system, Georeference& location)
{
  location.System = Georeference::Kind::Planar;
  if (OSRIsGeographic(system))
  {
    location.System = Georeference::Kind::Geographic;
    location.Unit = OSRGetAngularUnits(system, nullptr) * 180.0 / M_PI;
  }
  else if (OSRIsGeocentric(system))
  {
    location.System = Georeference::Kind::Unsupported;
  }
  else
  {
    location.Unit = OSRGetLinearUnits(system, nullptr);
  }
  OGRErr failure = OGRERR_NONE;
  const double axis = OSRGetSemiMajor(system, &failure);
  if (failure == OGRERR_NONE && axis > 0.0)
  {
    const double inverse = OSRGetInvFlattening(system, nullptr);
    location.SemiMajorAxis = axis;
    location.Flattening = inverse != 0.0 ? 1.0 / inverse : 0.0;
    if (!std::isfinite(axis) || !std::isfinite(location.Flattening) || location.Flattening >= 1.0)
    {
      location.System = Georeference::Kind::NoEllipsoid;
    }
  }
}

bool FindScale(const Georeference& location, double& scale)
{
  GDALSession session;
  const SpatialReference system = NewSpatialReference(location.WKT);
  const SpatialReference geographic(system ? OSRCloneGeogCS(system.get()) : nullptr);
  if (!geographic)
  {
    return false;
  }
  OSRSetAxisMappingStrategy(geographic.get(), OAMS_TRADITIONAL_GIS_ORDER);
  const double radians = OSRGetAngularUnits(geographic.get(), nullptr);
  const double step = 100.0 / location.Unit; // 100 m
  const std::array<double, 2> centre = location.Coordinates(0.5, 0.5);
  double x[3] = { centre[0], centre[0] + step, centre[0] };
  double y[3] = { centre[1], centre[1], centre[1] + step };
  OGRCoordinateTransformationH transformation =
    OCTNewCoordinateTransformation(system.get(), geographic.get());
  const bool isTransformed = transformation && OCTTransform(transformation, 3, x, y, nullptr);
  OCTDestroyCoordinateTransformation(transformation);
  if (!isTransformed)
  {
    return false;
  }
  const double latitude = y[0] * radians;
  const double squared = location.Flattening * (2.0 - location.Flattening);
  const double root = std::sqrt(1.0 - squared * std::pow(std::sin(latitude), 2));
  const double across = location.SemiMajorAxis / root;
  const double along = across * (1.0 - squared) / (root * root);
  double largest = 0.0; // absolute value of a logarithm
  for (int i = 1; i < 3; ++i)
  {
    const double east =
      std::remainder((x[i] - x[0]) * radians, 2.0 * M_PI) * across * std::cos(latitude);
    const double north = (y[i] - y[0]) * radians * along;
    const double logarithm = std::log(100.0 / std::hypot(east, north));
    largest = std::abs(logarithm) > std::abs(largest) ? logarithm : largest;
  }
  scale = std::exp(largest);
  return std::isfinite(scale);
}

namespace
{
// Angles are in degrees on the side of longitude and latitude.
bool ConvertGeographic(
  const std::string& definition, bool isToSystem, std::vector<std::array<double, 2>>& places)
{
  GDALSession session;
  const SpatialReference system = NewSpatialReference(definition);
  const SpatialReference geographic(system ? OSRCloneGeogCS(system.get()) : nullptr);
  if (!geographic)
  {
    return false;
  }
  OSRSetAxisMappingStrategy(geographic.get(), OAMS_TRADITIONAL_GIS_ORDER);
  OGRCoordinateTransformationH transformation = OCTNewCoordinateTransformation(
    isToSystem ? geographic.get() : system.get(), isToSystem ? system.get() : geographic.get());
  if (!transformation)
  {
    return false;
  }
  const double unit = OSRGetAngularUnits(geographic.get(), nullptr) * 180.0 / M_PI;
  for (std::array<double, 2>& place : places)
  {
    double x = isToSystem ? place[0] / unit : place[0];
    double y = isToSystem ? place[1] / unit : place[1];
    const bool isConverted = std::isfinite(x) && std::isfinite(y) &&
      OCTTransform(transformation, 1, &x, &y, nullptr) && std::isfinite(x) && std::isfinite(y);
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    place = { { isConverted ? x : none, isConverted ? y : none } };
    if (!isToSystem)
    {
      place = { { place[0] * unit, place[1] * unit } };
    }
  }
  OCTDestroyCoordinateTransformation(transformation);
  return true;
}

bool ConvertGeographic(const std::string& definition, bool isToSystem, std::array<double, 2>& place)
{
  std::vector<std::array<double, 2>> places = { place };
  if (!ConvertGeographic(definition, isToSystem, places) || std::isnan(places[0][0]))
  {
    return false;
  }
  place = places[0];
  return true;
}
}

bool GeographicToSystem(const std::string& definition, std::vector<std::array<double, 2>>& places)
{
  return ConvertGeographic(definition, true, places);
}

bool GeographicToSystem(const std::string& definition, std::array<double, 2>& place)
{
  return ConvertGeographic(definition, true, place);
}

bool SystemToGeographic(const std::string& definition, std::array<double, 2>& place)
{
  return ConvertGeographic(definition, false, place);
}
}
