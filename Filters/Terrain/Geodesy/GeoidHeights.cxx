// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Geodesy/GeoidHeights.h"

#if RELEVO_HAS_GDAL
#include "Geodesy/CoordinateSystem.h"
#include "Geodesy/GDALSession.h"
#endif

#include <GeographicLib/Geoid.hpp>

#include <algorithm>
#include <exception>
#include <vector>

namespace relevo
{
namespace
{
// The name of the vertical datum, or "".
std::string FindVerticalDatum(const std::string& coordinateSystem)
{
#if RELEVO_HAS_GDAL
  GDALSession session;
  const SpatialReference system = NewSpatialReference(coordinateSystem);
  const char* name = system ? OSRGetAttrValue(system.get(), "VERT_DATUM", 0) : nullptr;
  return name ? name : "";
#else
  (void)coordinateSystem;
  return "";
#endif
}

// GeographicLib's names, those with 5' first, which are accurate to centimetres.
std::vector<std::string> GetGeoidNames(const std::string& datum)
{
  const auto contains = [&datum](const char* part)
  { return datum.find(part) != std::string::npos; };
  if (contains("EGM2008") || contains("EGM 2008"))
  {
    return { "egm2008-5", "egm2008-2_5", "egm2008-1" };
  }
  if (contains("EGM96") || contains("EGM 96") || contains("EGM1996"))
  {
    return { "egm96-5", "egm96-15" };
  }
  if (contains("EGM84") || contains("EGM 84") || contains("EGM1984"))
  {
    return { "egm84-15", "egm84-30" };
  }
  return {};
}
}

GeoidHeights::GeoidHeights(const std::string& coordinateSystem)
{
  const std::string datum = FindVerticalDatum(coordinateSystem);
  if (datum.empty() || datum.find("llipsoid") != std::string::npos)
  {
    return;
  }
  const std::vector<std::string> names = GetGeoidNames(datum);
  for (const std::string& name : names)
  {
    try
    {
      // Cubic interpolation; all data are read, so that several threads can use them.
      this->Geoid = std::make_unique<const GeographicLib::Geoid>(name, "", true, true);
      return;
    }
    catch (const std::exception&)
    {
      continue; // it is not installed
    }
  }
  this->Warning = " has heights above \"" + datum +
    "\", which are drawn as heights above the ellipsoid. " +
    (names.empty() ? "Only EGM2008, EGM96 and EGM84 are supported: convert the file with gdalwarp."
                   : "Install the geoid " + names.front() +
          " of GeographicLib (geographiclib-get-geoids), or set GEOGRAPHICLIB_GEOID_PATH.");
}

GeoidHeights::~GeoidHeights() = default;

double GeoidHeights::Get(double longitude, double latitude) const
{
  return this->Geoid ? (*this->Geoid)(std::clamp(latitude, -90.0, 90.0), longitude) : 0.0;
}
}
