// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/FlightCheck.h"

#include "Text/ViewerMessages.h"

#include "vtkTerrainPyramid.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <sstream>

namespace
{
// The distance of a position from a raster, in lengths of its diagonal; infinity if it cannot be
// converted to the raster's coordinates.
double FindDistance(vtkTerrainPyramid* pyramid, double longitude, double latitude)
{
  const double degrees[2] = { longitude, latitude };
  double coordinates[2];
  double sample[2];
  if (!pyramid->GeographicToRaster(degrees, coordinates) ||
    !pyramid->RasterToSample(coordinates, sample))
  {
    return std::numeric_limits<double>::infinity();
  }
  int size[2];
  pyramid->GetDimensions(size);
  double outside[2];
  for (int axis = 0; axis < 2; ++axis)
  {
    outside[axis] = std::max({ -0.5 - sample[axis], sample[axis] - (size[axis] - 0.5), 0.0 });
  }
  return std::hypot(outside[0], outside[1]) / std::hypot(size[0], size[1]);
}

// "longitudes from 10 to 10.4 and latitudes from 45 to 45.3"
std::string DescribeBounds(vtkTerrainPyramid* pyramid)
{
  const int intervals = 16;
  int size[2];
  pyramid->GetDimensions(size);
  double low[2] = { std::numeric_limits<double>::max(), std::numeric_limits<double>::max() };
  double high[2] = { std::numeric_limits<double>::lowest(), std::numeric_limits<double>::lowest() };
  for (int i = 0; i <= intervals; ++i)
  {
    for (int j = 0; j <= intervals; ++j)
    {
      const double sample[2] = { static_cast<double>(i) / intervals * size[0] - 0.5,
        static_cast<double>(j) / intervals * size[1] - 0.5 };
      double coordinates[2];
      double degrees[2];
      if (pyramid->SampleToRaster(sample, coordinates) &&
        pyramid->RasterToGeographic(coordinates, degrees))
      {
        for (int axis = 0; axis < 2; ++axis)
        {
          low[axis] = std::min(low[axis], degrees[axis]);
          high[axis] = std::max(high[axis], degrees[axis]);
        }
      }
    }
  }
  std::ostringstream text;
  text << std::setprecision(8) << "longitudes from " << low[0] << " to " << high[0]
       << " and latitudes from " << low[1] << " to " << high[1];
  return text.str();
}
}

//------------------------------------------------------------------------------
void CheckFlightPositions(const std::string& fileName, const std::vector<FlightPosition>& positions,
  const std::string& input, vtkTerrainPyramid* pyramid, ViewerMessages& messages)
{
  std::size_t outside = 0;
  std::size_t swapped = 0; // within the raster if the two columns are exchanged
  double nearest = std::numeric_limits<double>::infinity();
  for (const FlightPosition& position : positions)
  {
    const double distance = FindDistance(pyramid, position.Longitude, position.Latitude);
    nearest = std::min(nearest, distance);
    outside += distance > 0.0 ? 1 : 0;
    const bool canSwap = distance > 0.0 && std::abs(position.Longitude) <= 90.0;
    swapped +=
      canSwap && FindDistance(pyramid, position.Latitude, position.Longitude) == 0.0 ? 1 : 0;
  }
  if (outside == 0)
  {
    return;
  }
  const std::string place = " outside of " + input + ", which has " + DescribeBounds(pyramid);
  if (nearest > 1.0)
  {
    throw ViewerError(fileName + ": all " + std::to_string(outside) + " positions are far" + place +
      (swapped == outside ? ". Exchange longitudes and latitudes" : ""));
  }
  messages.Warn(fileName + ": " + std::to_string(outside) + " of " +
    std::to_string(positions.size()) + " positions are" + place);
}
