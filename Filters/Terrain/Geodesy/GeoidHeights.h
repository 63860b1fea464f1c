// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   GeoidHeights
 * @brief   heights of the geoid of a vertical coordinate system above the ellipsoid
 *
 * The geoids are EGM2008, EGM96 and EGM84, if the data of GeographicLib are installed; see
 * GeographicLib::Geoid. Private to the module.
 */
#ifndef GeoidHeights_h
#define GeoidHeights_h

#include "RelevoFiltersTerrainModule.h" // for export macro

#include <memory>
#include <string>

namespace GeographicLib
{
class Geoid;
}

namespace relevo
{
class RELEVOFILTERSTERRAIN_EXPORT GeoidHeights
{
public:
  /// Bounds of all heights in metres.
  static constexpr double Lowest = -110.0;
  static constexpr double Highest = 90.0;

  /// The coordinate system is WKT. Without a vertical part, heights are those above the ellipsoid.
  explicit GeoidHeights(const std::string& coordinateSystem);
  ~GeoidHeights();

  bool HasGeoid() const { return this->Geoid != nullptr; }
  /// The height in metres at a longitude and latitude in degrees; 0 without a geoid. Thread-safe.
  double Get(double longitude, double latitude) const;

  /// Why heights above a geoid are drawn as those above the ellipsoid, as a continuation of the
  /// raster's name, or "".
  const std::string& GetWarning() const { return this->Warning; }

private:
  std::unique_ptr<const GeographicLib::Geoid> Geoid;
  std::string Warning;
};
}

#endif
