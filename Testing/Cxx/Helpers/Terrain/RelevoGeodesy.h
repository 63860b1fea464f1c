// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Terrain coordinates of points on the earth, for tests.
#ifndef RelevoGeodesy_h
#define RelevoGeodesy_h

#include <array>
#include <cmath>

// East, north and up of a point on the ellipsoid relative to another one, by the textbook formula.
inline std::array<double, 3> RelevoEastNorthUp(double longitude, double latitude, double longitude0,
  double latitude0, double a = 6378137.0, double f = 1.0 / 298.257223563)
{
  const double e2 = f * (2.0 - f);
  const auto place = [&](double lon, double lat)
  {
    const double n = a / std::sqrt(1.0 - e2 * std::sin(lat) * std::sin(lat));
    return std::array<double, 3>{ n * std::cos(lat) * std::cos(lon),
      n * std::cos(lat) * std::sin(lon), n * (1.0 - e2) * std::sin(lat) };
  };
  const double radians = std::acos(-1.0) / 180.0;
  const double lon0 = longitude0 * radians;
  const double lat0 = latitude0 * radians;
  const auto p = place(longitude * radians, latitude * radians);
  const auto q = place(lon0, lat0);
  const double d[3] = { p[0] - q[0], p[1] - q[1], p[2] - q[2] };
  return { -std::sin(lon0) * d[0] + std::cos(lon0) * d[1],
    -std::sin(lat0) * std::cos(lon0) * d[0] - std::sin(lat0) * std::sin(lon0) * d[1] +
      std::cos(lat0) * d[2],
    std::cos(lat0) * std::cos(lon0) * d[0] + std::cos(lat0) * std::sin(lon0) * d[1] +
      std::sin(lat0) * d[2] };
}

#endif
