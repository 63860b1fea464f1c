// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   what relevo-view is asked to do
 */
#ifndef ViewerOptions_h
#define ViewerOptions_h

#include <array>
#include <optional>
#include <stdexcept>
#include <string>

struct ViewerOptions
{
  enum class MetricType
  {
    Distance,
    ScreenEdge,
    Curvature,
    Silhouette,
    Contour,
    ViewDependent,
    Field,
    Region
  };
  enum class ColorType
  {
    Terrain,
    Level,
    Pattern,
    Metric
  };
  static constexpr double DefaultPixels = 4.0;

  std::string HeightMap;
  std::string Imagery;
  int ImageryBands[3] = { 0, 0, 0 }; // as vtkTerrainSource has them
  bool Stretch = false;
  double Exaggeration = 1.0;
  std::optional<int> MaximumLevel;
  MetricType Metric = MetricType::Distance;
  std::optional<double> Pixels;                // of ScreenEdge
  std::optional<double> Reach;                 // of Distance
  std::optional<std::array<double, 3>> Region; // x, y, radius
  bool PerEdge = false;
  bool WholeSegments = false;
  bool Geomorphing = true;
  int Budget = 0; // triangles; 0 for as many as it takes
  ColorType Color = ColorType::Terrain;
  std::optional<int> Resolution;
  bool FillNoData = false;
  bool Wireframe = false;
  bool Statistics = false;
  int Size[2] = { 1280, 800 };
  std::string Output;
  std::string Export;
  bool Help = false;
};

/// Bad usage: what is wrong with the arguments.
struct UsageError : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/// Throws UsageError.
ViewerOptions ParseOptions(int argc, char* argv[]);

/// The text of --help.
const char* GetUsage();

#endif
