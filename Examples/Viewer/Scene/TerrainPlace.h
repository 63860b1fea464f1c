// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   the places and the shape of a height map, in messages and options
 */
#ifndef TerrainPlace_h
#define TerrainPlace_h

#include <array>
#include <optional>
#include <string>

class TerrainGround;
class ViewerMessages;
struct ViewerOptions;

/// The unit of the raster's heights, or an empty string if unknown.
std::string GetHeightUnit(TerrainGround& ground);

/// Position, height and coordinates at a point, as lines of text.
std::string DescribePlace(TerrainGround& ground, const double point[3], double resolution);

/// The point of --center, if given. Throws ViewerError if there is no terrain.
std::optional<std::array<double, 3>> FindCentre(
  const ViewerOptions& options, TerrainGround& ground, ViewerMessages& messages);

/// The message for an error of a raster's reader.
std::string ExplainRasterError(const std::string& input, const std::string& text);

/// Lengths in world coordinates, at an exaggeration of that of the options, or 1.
struct TerrainShape
{
  double Range[2]; // of the heights, in their unit
  double Width;
  double Relief;
  bool HasCoordinateSystem;
  bool CountsSamples; // there is no georeference
};

/**
 * The exaggeration of the options, or one for heights and coordinates with different units, such as
 * grey levels over samples, with the reason for the user. Throws ViewerError if the terrain would
 * be too high.
 */
double FindExaggeration(
  const ViewerOptions& options, const TerrainShape& shape, std::string& reason);

#endif
