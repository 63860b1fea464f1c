// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   interpretation of coordinate systems with GDAL
 *
 * Private to the module. Compiled only with RELEVO_USE_GDAL.
 */
#ifndef CoordinateSystem_h
#define CoordinateSystem_h

#include "Geodesy/Georeference.h"

#include <ogr_srs_api.h>

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace relevo
{
struct SpatialReferenceFreer
{
  void operator()(void* system) const { OSRDestroySpatialReference(system); }
};
using SpatialReference = std::unique_ptr<void, SpatialReferenceFreer>;

/**
 * Parses WKT or any other definition that GDAL accepts, such as EPSG:32633. Coordinates are in the
 * order of rasters: longitude or easting first. Returns nullptr if the definition is invalid.
 */
SpatialReference NewSpatialReference(const std::string& definition);

/**
 * Sets the kind, unit and ellipsoid of the location. PROJ accepts ellipsoids with invalid axis or
 * flattening, for which GeographicLib throws an exception. They are reported as NoEllipsoid.
 */
void DescribeCoordinateSystem(OGRSpatialReferenceH system, Georeference& location);

/// Computes map length / ellipsoid length at the centre. Of the scales to the east and to the
/// north, it is the one farther from 1. Returns false if it cannot be computed.
bool FindScale(const Georeference& location, double& scale);

//@{
/// Converts longitude and latitude in degrees, on the ellipsoid of the system, to its coordinates,
/// and back. The second function converts many, those that it cannot convert to NaN; it returns
/// false if there is no such system.
bool GeographicToSystem(const std::string& definition, std::array<double, 2>& place);
bool GeographicToSystem(const std::string& definition, std::vector<std::array<double, 2>>& places);
bool SystemToGeographic(const std::string& definition, std::array<double, 2>& place);
//@}
}

#endif
