// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/TerrainPlace.h"

#include "Files/ResultFormats.h"
#include "Options/ViewerOptions.h"
#include "Scene/TerrainGround.h"
#include "Text/ViewerMessages.h"
#include "Text/ViewerText.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>
#include <vector>

namespace
{
// "86.925E"
std::string ToText(double degrees, char positive, char negative)
{
  std::ostringstream text;
  text << std::setprecision(9) << std::abs(degrees) << (degrees < 0.0 ? negative : positive);
  return text.str();
}

std::array<double, 3> FindGround(const ViewerOptions& options, TerrainGround& ground,
  const double place[2], const std::string& text)
{
  double height;
  if (!ground.GetHeight(place[0], place[1], height))
  {
    if (options.Globe)
    {
      throw ViewerError(
        options.Input + " has no height at --center " + text + ". Give degrees within its data");
    }
    const std::array<double, 4> extent = ground.GetExtent();
    std::ostringstream message;
    message << options.Input << " has no height at --center " << text << "; its x ranges from "
            << extent[0] << " to " << extent[1] << ", its y from " << extent[2] << " to "
            << extent[3] << ". Give X,Y in "
            << (ground.HasCoordinateSystem()
                   ? "metres from its centre, degrees such as 86.925E,27.988N"
                   : "texels from its centre")
            << ", or X,Y,Z for a point without terrain";
    throw ViewerError(message.str());
  }
  return { { place[0], place[1], ground.GetZ(height) } };
}

std::array<double, 3> FindDegrees(
  const ViewerOptions& options, TerrainGround& ground, const std::array<double, 2>& degrees)
{
  if (!ground.HasCoordinateSystem())
  {
    throw ViewerError(options.Input +
      " has no coordinate system, so --center cannot be in degrees; give X,Y in texels from its "
      "centre");
  }
  const std::string text = ToText(degrees[0], 'E', 'W') + "," + ToText(degrees[1], 'N', 'S');
  double place[2];
  if (!ground.FromDegrees(degrees.data(), place))
  {
    throw ViewerError(options.Input + " has no height at --center " + text +
      ", which is too far away; write degrees as 86.925E,27.988N");
  }
  return FindGround(options, ground, place, text);
}

// Whether the numbers of --center look like a longitude and a latitude.
bool IsInRaster(TerrainGround& ground, const double degrees[2])
{
  double place[2];
  double height;
  return std::abs(degrees[0]) <= 360.0 && std::abs(degrees[1]) <= 90.0 &&
    ground.HasCoordinateSystem() && ground.FromDegrees(degrees, place) &&
    ground.GetHeight(place[0], place[1], height);
}

// Chooses an exaggeration for heights that are more than the width.
double ChooseExaggeration(const std::string& input, const TerrainShape& shape, std::string& reason)
{
  const double maximumHeights = 1.0; // per width
  const double chosenHeights = 0.2;
  if (shape.Relief <= maximumHeights * shape.Width)
  {
    return 1.0;
  }
  // Two digits are easy to read and to change.
  std::ostringstream digits;
  digits << std::setprecision(2) << chosenHeights * shape.Width / shape.Relief;
  std::ostringstream message;
  message << std::setprecision(3) << input << ": --exaggeration " << digits.str()
          << " is chosen, because "
          << (shape.CountsSamples
                 ? "there is no georeference (texels are taken as 1 m wide)"
                 : "there is no coordinate system (coordinates are taken as metres)")
          << " and the heights in metres would be " << shape.Relief / shape.Width
          << " times the width";
  reason = message.str();
  return std::stod(digits.str());
}
}

//------------------------------------------------------------------------------
std::string GetHeightUnit(TerrainGround& ground)
{
  if (!ground.HasCoordinateSystem())
  {
    return "";
  }
  const double metres = ground.GetVerticalUnit();
  const auto isUnit = [=](double length) { return std::abs(metres - length) < 1e-5 * length; };
  return isUnit(1.0) ? "m" : isUnit(0.3048) ? "ft" : "";
}

//------------------------------------------------------------------------------
std::string DescribePlace(TerrainGround& ground, const double point[3], double resolution)
{
  const double metresInDegree = 111320.0;
  const bool isKnown = ground.HasCoordinateSystem();
  const bool isGeographic = ground.IsGeographic();
  const std::string unit = isKnown ? " m" : "";
  std::string text = "x " + FormatNumber(point[0], resolution) + unit + "  y " +
    FormatNumber(point[1], resolution) + unit;
  double height;
  if (ground.GetHeight(point[0], point[1], height))
  {
    const std::string heightUnit = GetHeightUnit(ground);
    text +=
      "  height " + FormatNumber(height, resolution) + (heightUnit.empty() ? "" : " " + heightUnit);
  }
  const auto add = [&](const char* first, const char* second, const double numbers[2], double exact)
  {
    text += std::string("\n") + first + " " + FormatNumber(numbers[0], exact) + "  " + second +
      " " + FormatNumber(numbers[1], exact);
  };
  double numbers[2];
  if (ground.ToRaster(point, numbers))
  {
    add(isGeographic ? "longitude"
        : isKnown    ? "east"
                     : "column",
      isGeographic ? "latitude"
        : isKnown  ? "north"
                   : "row",
      numbers, isGeographic ? resolution / metresInDegree : resolution);
  }
  if (ground.ToDegrees(point, numbers))
  {
    add("longitude", "latitude", numbers, resolution / metresInDegree);
  }
  return text;
}

//------------------------------------------------------------------------------
std::optional<std::array<double, 3>> FindCentre(
  const ViewerOptions& options, TerrainGround& ground, ViewerMessages& messages)
{
  if (options.CenterDegrees)
  {
    return FindDegrees(options, ground, *options.CenterDegrees);
  }
  if (!options.Center)
  {
    return std::nullopt;
  }
  const std::vector<double>& place = *options.Center;
  if (place.size() == 3)
  {
    return { { { place[0], place[1], place[2] } } };
  }
  std::ostringstream text;
  text << place[0] << "," << place[1];
  if (IsInRaster(ground, place.data()))
  {
    messages.Warn("--center " + text.str() +
      " is taken as metres from the raster's centre; for degrees, use --center " +
      ToText(place[0], 'E', 'W') + "," + ToText(place[1], 'N', 'S'));
  }
  return FindGround(options, ground, place.data(), text.str());
}

//------------------------------------------------------------------------------
std::string ExplainRasterError(const std::string& input, const std::string& text)
{
  // GDAL opens Exodus files as netCDF. Other files may be meshes in a format without a reader.
  const std::string advice = AdviseFormat(input, GetMeshFormats());
  const bool isExodus = advice.find("Exodus") != std::string::npos;
  const bool isUnknown = text.find("recogni") != std::string::npos && !advice.empty();
  return isExodus || isUnknown
    ? "Cannot read " + input + ": it cannot be read as a height map" + advice + "."
    : text;
}

//------------------------------------------------------------------------------
double FindExaggeration(
  const ViewerOptions& options, const TerrainShape& shape, std::string& reason)
{
  // A higher terrain would be a needle without visible detail.
  const double maximumHeights = 100.0; // per width
  // Larger values are missing-data markers.
  const double highestHeights = 1e6;
  if (!options.Exaggeration && !shape.HasCoordinateSystem &&
    shape.Relief < highestHeights * shape.Width)
  {
    return ChooseExaggeration(options.Input, shape, reason);
  }
  const double exaggeration = options.Exaggeration.value_or(1.0);
  if (shape.Relief > maximumHeights * shape.Width)
  {
    std::ostringstream message;
    message << std::setprecision(3) << options.Input << ": --exaggeration " << exaggeration
            << " makes the terrain " << shape.Relief / shape.Width
            << " times as high as wide, but at most " << maximumHeights
            << " times is allowed; use at most --exaggeration "
            << std::abs(exaggeration) * maximumHeights * shape.Width / shape.Relief
            << ". The heights range from " << shape.Range[0] << " to " << shape.Range[1]
            << ": if one of these is a missing value, name it with --no-data-value";
    throw ViewerError(message.str());
  }
  return exaggeration;
}
