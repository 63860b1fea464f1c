// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   what a coordinate system's coordinates mean, by GDAL
 *
 * Private to the module's own sources; only in builds with RELEVO_USE_GDAL.
 */
#ifndef CoordinateSystem_h
#define CoordinateSystem_h

#include "Geodesy/Georeference.h"

#include <ogr_srs_api.h>

#include <array>
#include <memory>
#include <string>

namespace relevo
{
struct SpatialReferenceFreer
{
  void operator()(void* system) const { OSRDestroySpatialReference(system); }
};
using SpatialReference = std::unique_ptr<void, SpatialReferenceFreer>;

/**
 * By WKT, or another definition that GDAL takes, as EPSG:32633; longitude or easting first, as
 * rasters have them. nullptr when it is none.
 */
SpatialReference NewSpatialReference(const std::string& definition);

/**
 * Sets the kind, unit and ellipsoid of the location. PROJ takes any number for an axis and a
 * flattening; GeographicLib throws where there is no such ellipsoid.
 */
void DescribeCoordinateSystem(OGRSpatialReferenceH system, Georeference& location);

/// Map lengths per length on the ellipsoid at the centre, of east and north that which is farther
/// from 1; false where that is not known.
bool FindScale(const Georeference& location, double& scale);

/// From longitude and latitude in degrees, on the system's own ellipsoid, to its coordinates.
bool GeographicToSystem(const std::string& definition, std::array<double, 2>& place);
}

#endif
