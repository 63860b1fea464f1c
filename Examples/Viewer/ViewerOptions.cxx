// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ViewerOptions.h"

#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <sstream>
#include <utility>
#include <vector>

namespace
{
const int HighestLevel = 7;
const int LargestBand = 65535;
const int LargestSize = 16384;
const int LargestResolution = 4096;

double ToNumber(const std::string& option, const std::string& text)
{
  std::size_t end = 0;
  double value = 0.0;
  try
  {
    value = std::stod(text, &end);
  }
  catch (const std::logic_error&)
  {
    end = 0;
  }
  if (end == 0 || end != text.size() || !std::isfinite(value))
  {
    throw UsageError(option + " wants a number, not '" + text + "'");
  }
  return value;
}

int ToInteger(const std::string& option, const std::string& text, int lowest, int highest)
{
  const double value = ToNumber(option, text);
  if (value != std::floor(value) || value < lowest || value > highest)
  {
    throw UsageError(option + " wants a whole number from " + std::to_string(lowest) + " to " +
      std::to_string(highest) + ", not '" + text + "'");
  }
  return static_cast<int>(value);
}

double ToPositiveNumber(const std::string& option, const std::string& text)
{
  const double value = ToNumber(option, text);
  if (value <= 0.0)
  {
    throw UsageError(option + " wants a number above 0, not '" + text + "'");
  }
  return value;
}

// What a word stands for.
template <typename T>
T ToChoice(const std::string& option, const std::string& text,
  const std::vector<std::pair<std::string, T>>& choices)
{
  std::string words;
  for (size_t i = 0; i < choices.size(); ++i)
  {
    if (choices[i].first == text)
    {
      return choices[i].second;
    }
    words += (i == 0 ? "" : i + 1 < choices.size() ? ", " : " or ") + choices[i].first;
  }
  throw UsageError(option + " wants " + words + ", not '" + text + "'");
}

void ToSize(const std::string& option, const std::string& text, int size[2])
{
  const std::size_t cross = text.find('x');
  if (cross == std::string::npos)
  {
    throw UsageError(option + " wants WIDTHxHEIGHT, not '" + text + "'");
  }
  size[0] = ToInteger(option, text.substr(0, cross), 1, LargestSize);
  size[1] = ToInteger(option, text.substr(cross + 1), 1, LargestSize);
}

void ToBands(const std::string& option, const std::string& text, int bands[3])
{
  std::istringstream stream(text);
  std::string band;
  int count = 0;
  for (; count < 3 && std::getline(stream, band, ','); ++count)
  {
    bands[count] = ToInteger(option, band, 1, LargestBand);
  }
  if (count < 3 || !stream.eof())
  {
    throw UsageError(option + " wants three bands, as 3,2,1, not '" + text + "'");
  }
}

std::array<double, 3> ToRegion(const std::string& option, const std::string& text)
{
  std::istringstream stream(text);
  std::string number;
  std::array<double, 3> region{};
  size_t count = 0;
  for (; count < 3 && std::getline(stream, number, ','); ++count)
  {
    region[count] = count < 2 ? ToNumber(option, number) : ToPositiveNumber(option, number);
  }
  if (count < 3 || !stream.eof())
  {
    throw UsageError(option + " wants X,Y,RADIUS, not '" + text + "'");
  }
  return region;
}

std::string ToFileName(
  const std::string& option, const std::string& text, const std::string& extension)
{
  if (text.size() <= extension.size() ||
    text.compare(text.size() - extension.size(), extension.size(), extension) != 0)
  {
    throw UsageError(option + " wants the name of a " + extension + " file, not '" + text + "'");
  }
  return text;
}

void CheckUse(const std::string& option, bool isUsed, bool isUseful, const std::string& metric)
{
  if (isUsed && !isUseful)
  {
    throw UsageError(option + " goes with --metric " + metric);
  }
}
}

//------------------------------------------------------------------------------
ViewerOptions ParseOptions(int argc, char* argv[])
{
  ViewerOptions options;
  const std::map<std::string, std::function<void()>> flags = {
    { "--help", [&] { options.Help = true; } },
    { "-h", [&] { options.Help = true; } },
    { "--no-geomorphing", [&] { options.Geomorphing = false; } },
    { "--per-edge", [&] { options.PerEdge = true; } },
    { "--stats", [&] { options.Statistics = true; } },
    { "--stretch", [&] { options.Stretch = true; } },
    { "--wireframe", [&] { options.Wireframe = true; } },
  };
  using Setter = std::function<void(const std::string& option, const std::string& value)>;
  const std::map<std::string, Setter> settings = {
    { "--budget",
      [&](const auto& option, const auto& value)
      { options.Budget = ToInteger(option, value, 1, std::numeric_limits<int>::max()); } },
    { "--color-by",
      [&](const auto& option, const auto& value)
      {
        using Type = ViewerOptions::ColorType;
        options.Color = ToChoice<Type>(option, value,
          { { "level", Type::Level }, { "pattern", Type::Pattern }, { "metric", Type::Metric } });
      } },
    { "--exaggeration",
      [&](const auto& option, const auto& value)
      { options.Exaggeration = ToNumber(option, value); } },
    { "--export",
      [&](const auto& option, const auto& value)
      { options.Export = ToFileName(option, value, ".vtp"); } },
    { "--imagery", [&](const auto&, const auto& value) { options.Imagery = value; } },
    { "--imagery-bands",
      [&](const auto& option, const auto& value)
      { ToBands(option, value, options.ImageryBands); } },
    { "--max-level",
      [&](const auto& option, const auto& value)
      { options.MaximumLevel = ToInteger(option, value, 0, HighestLevel); } },
    { "--metric",
      [&](const auto& option, const auto& value)
      {
        using Type = ViewerOptions::MetricType;
        options.Metric = ToChoice<Type>(option, value,
          { { "distance", Type::Distance }, { "screen-edge", Type::ScreenEdge },
            { "curvature", Type::Curvature }, { "silhouette", Type::Silhouette },
            { "contour", Type::Contour }, { "view-dependent", Type::ViewDependent },
            { "field", Type::Field }, { "region", Type::Region } });
      } },
    { "--no-data",
      [&](const auto& option, const auto& value) {
        options.FillNoData = ToChoice<bool>(option, value, { { "hole", false }, { "fill", true } });
      } },
    { "--output",
      [&](const auto& option, const auto& value)
      { options.Output = ToFileName(option, value, ".png"); } },
    { "--pixels",
      [&](const auto& option, const auto& value)
      { options.Pixels = ToPositiveNumber(option, value); } },
    { "--reach",
      [&](const auto& option, const auto& value)
      { options.Reach = ToPositiveNumber(option, value); } },
    { "--region",
      [&](const auto& option, const auto& value) { options.Region = ToRegion(option, value); } },
    { "--resolution",
      [&](const auto& option, const auto& value)
      { options.Resolution = ToInteger(option, value, 1, LargestResolution); } },
    { "--segments",
      [&](const auto& option, const auto& value)
      {
        options.WholeSegments =
          ToChoice<bool>(option, value, { { "powers", false }, { "whole", true } });
      } },
    { "--size",
      [&](const auto& option, const auto& value) { ToSize(option, value, options.Size); } },
  };

  for (int i = 1; i < argc; ++i)
  {
    std::string argument = argv[i];
    const auto flag = flags.find(argument);
    if (flag != flags.end())
    {
      flag->second();
      continue;
    }
    if (argument.size() < 2 || argument[0] != '-')
    {
      if (!options.HeightMap.empty())
      {
        throw UsageError(
          "one height map, please: '" + options.HeightMap + "' or '" + argument + "'");
      }
      options.HeightMap = argument;
      continue;
    }
    // --option VALUE or --option=VALUE
    const std::size_t equals = argument.find('=');
    const std::string option = argument.substr(0, equals);
    const auto setting = settings.find(option);
    if (setting == settings.end())
    {
      throw UsageError("unknown option '" + option + "'");
    }
    if (equals == std::string::npos && i + 1 == argc)
    {
      throw UsageError(option + " wants a value");
    }
    setting->second(option, equals == std::string::npos ? argv[++i] : argument.substr(equals + 1));
  }
  using Type = ViewerOptions::MetricType;
  CheckUse(
    "--pixels", options.Pixels.has_value(), options.Metric == Type::ScreenEdge, "screen-edge");
  CheckUse("--reach", options.Reach.has_value(), options.Metric == Type::Distance, "distance");
  CheckUse("--region", options.Region.has_value(), options.Metric == Type::Region, "region");
  if (options.Budget > 0 && !options.Export.empty())
  {
    throw UsageError("--budget is for what is drawn, not for --export");
  }
  if (options.HeightMap.empty() && !options.Help)
  {
    throw UsageError("which height map?");
  }
  return options;
}

//------------------------------------------------------------------------------
const char* GetUsage()
{
  return R"(relevo-view HEIGHTMAP [options]

Draws a height map (GeoTIFF, SRTM .hgt, USGS DEM, PNG, OpenEXR ...), refined where it matters:
a window when there is a display, a picture with --output.

  --imagery FILE         drape a georeferenced picture over it; else colours show the height
  --imagery-bands R,G,B  which of its bands, from 1, are red, green and blue (default: as the file
                         says, else 1,2,3)
  --stretch              stretch the contrast of each band, as raw satellite images need
  --exaggeration X       factor on heights (default 1)
  --resolution N         coarse squares along the longer side (default 128)
  --max-level N          deepest refinement, 0 to 7: an edge has up to 2^N segments (default: as
                         fine as the height map, or as the pixels of the picture)
  --metric NAME          what to refine: distance (default; what is near), screen-edge (what is
                         long on the screen), curvature, silhouette, contour (outlines by normals
                         or by faces), view-dependent (bent and seen edge-on), field (where the
                         height varies), region (around a place)
  --reach M              metres from the camera that distance refines (default: three times the
                         terrain's diagonal)
  --pixels N             length of a segment on the screen for screen-edge (default 4)
  --region X,Y,RADIUS    the place for region, in metres from the terrain's centre
  --per-edge             levels of edges by themselves, not as the mean of their ends': fewer
                         triangles
  --segments powers|whole
                         edges of 2^level segments (default), or of any number up to 16
  --no-geomorphing       let vertices appear where they belong, instead of sliding there
  --budget N             about N triangles, by raising or lowering all levels
  --color-by level|pattern|metric
                         show these instead of the terrain's colours, with a legend
  --no-data hole|fill    leave out what has no data (default), or fill it in smoothly
  --wireframe            draw the edges of the refined triangles
  --stats                print faces, triangles, draw calls, graphics memory and times
  --size WxH             of the picture or the window, in pixels (default 1280x800)
  --output FILE.png      write a picture and leave; needs no display
  --export FILE.vtp      write the displaced refined mesh (metres: x east, y north, z up) and leave
  --help                 this text

In the window: left button turns, middle or shift + left moves, right or wheel zooms, w and s
switch wireframe and surface, r resets the view, q leaves.

Exit codes: 0 success, 1 bad input, 2 bad usage.
)";
}
