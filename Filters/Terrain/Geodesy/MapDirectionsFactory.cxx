// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Geodesy/MapDirectionsFactory.h"

#if RELEVO_HAS_GDAL
#include "Geodesy/CoordinateSystem.h"
#include "Geodesy/GDALSession.h"
#include "Geodesy/GridDirections.h"
#include "Geodesy/TangentDirections.h"
#endif

#include <cmath>

namespace relevo
{
std::unique_ptr<MapDirections> NewMapDirections(
  const std::string& system, const MapPlace& origin, std::string& error)
{
  error.clear();
  if (system.empty())
  {
    return nullptr;
  }
#if RELEVO_HAS_GDAL
  GDALSession session;
  const SpatialReference reference = NewSpatialReference(system);
  if (!reference)
  {
    error = session.Messages("GDAL does not recognise it");
    return nullptr;
  }
  Georeference location;
  DescribeCoordinateSystem(reference.get(), location);
  if (location.System == Georeference::Kind::Unsupported)
  {
    error = "it uses neither longitude and latitude nor a projection";
    return nullptr;
  }
  if (location.System == Georeference::Kind::NoEllipsoid)
  {
    error = "its ellipsoid is not supported: the flattening must be less than 1";
    return nullptr;
  }
  if (location.System == Georeference::Kind::Geographic)
  {
    return std::make_unique<TangentDirections>(location, origin);
  }
  if (OSRIsLocal(reference.get()))
  {
    return nullptr;
  }
  auto directions = std::make_unique<GridDirections>(system, location, origin);
  if (!directions->IsValid())
  {
    error = session.Messages("its coordinates cannot be converted to longitude and latitude");
    return nullptr;
  }
  return directions;
#else
  error = "coordinate systems require GDAL, and this build of Relevo does not have it";
  return nullptr;
#endif
}
}
