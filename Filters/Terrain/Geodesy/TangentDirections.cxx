// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Geodesy/TangentDirections.h"

#include "Geodesy/Georeference.h"
#include "vtkSMPTools.h"

#include <GeographicLib/Geocentric.hpp>
#include <GeographicLib/LocalCartesian.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace relevo
{
namespace
{
constexpr int MaximumSteps = 50;
constexpr double Tolerance = 1e-3; // metres of height

// The rotation from east, north, up at the place on the ellipsoid to those at the frame's origin,
// by rows. False beyond the horizon.
bool findRotation(const GeographicLib::LocalCartesian& frame, const MapPlace& place, double* m)
{
  // Newton's method for the drop of the ellipsoid below the tangent plane: from above, where the
  // height is convex in z, it comes down monotonically.
  double z = 0.0;
  std::vector<double> rotation(9);
  for (int step = 0; step < MaximumSteps; ++step)
  {
    double latitude;
    double longitude;
    double height;
    frame.Reverse(place[0], place[1], z, latitude, longitude, height, rotation);
    const double slope = rotation[8]; // of the height along z
    if (!(slope > 0.0) || !std::isfinite(height))
    {
      return false;
    }
    if (std::abs(height) < Tolerance)
    {
      std::copy(rotation.begin(), rotation.end(), m);
      return true;
    }
    z -= height / slope;
  }
  return false;
}
}

struct TangentDirections::Tangent
{
  GeographicLib::LocalCartesian Frame;
};

TangentDirections::TangentDirections(const Georeference& system, const MapPlace& origin)
  : Frame(new Tangent{ GeographicLib::LocalCartesian(
      std::clamp(origin[1] * system.Unit, -90.0, 90.0), origin[0] * system.Unit, 0.0,
      GeographicLib::Geocentric(system.SemiMajorAxis, system.Flattening)) })
{
}

TangentDirections::~TangentDirections() = default;

void TangentDirections::Evaluate(
  const std::vector<MapPlace>& places, std::vector<MapAxes>& axes) const
{
  axes.resize(places.size());
  vtkSMPTools::For(0, static_cast<vtkIdType>(places.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        double m[9];
        if (!findRotation(this->Frame->Frame, places[i], m))
        {
          std::fill_n(m, 9, std::numeric_limits<double>::quiet_NaN());
        }
        axes[i] = { { m[0], m[3] }, { m[1], m[4] } };
      }
    });
}
}
