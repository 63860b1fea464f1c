// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Geodesy/CoordinateSystem.h"

#include "Geodesy/GDALSession.h"

#include <cmath>

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

bool GeographicToSystem(const std::string& definition, std::array<double, 2>& place)
{
  GDALSession session;
  const SpatialReference system = NewSpatialReference(definition);
  const SpatialReference geographic(system ? OSRCloneGeogCS(system.get()) : nullptr);
  if (!geographic)
  {
    return false;
  }
  OSRSetAxisMappingStrategy(geographic.get(), OAMS_TRADITIONAL_GIS_ORDER);
  const double unit = OSRGetAngularUnits(geographic.get(), nullptr) * 180.0 / M_PI;
  std::array<double, 2> result = { place[0] / unit, place[1] / unit };
  OGRCoordinateTransformationH transformation =
    OCTNewCoordinateTransformation(geographic.get(), system.get());
  const bool isTransformed =
    transformation && OCTTransform(transformation, 1, &result[0], &result[1], nullptr);
  OCTDestroyCoordinateTransformation(transformation);
  if (isTransformed && std::isfinite(result[0]) && std::isfinite(result[1]))
  {
    place = result;
    return true;
  }
  return false;
}
}
