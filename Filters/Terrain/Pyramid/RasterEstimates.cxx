// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Pyramid/RasterEstimates.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace relevo
{
std::array<double, 2> EstimateRange(const PyramidFile& file)
{
  const int level = file.GetNumberOfLevels() - 1;
  const std::array<int, 2>& size = file.GetSize(level);
  // A small level as a whole, of a large one some samples.
  constexpr int windows = 8;
  constexpr int windowSize = 16;
  std::vector<SampleWindow> parts;
  const bool isSmall = static_cast<double>(size[0]) * size[1] <= 1 << 20;
  if (isSmall)
  {
    parts.push_back({ level, 0, 0, size[0], size[1] });
  }
  for (int i = 0; !isSmall && i < windows * windows; ++i)
  {
    const double at[2] = { (i % windows + 0.5) / windows, (i / windows + 0.5) / windows };
    SampleWindow part;
    part.Level = level;
    part.Width = std::min(windowSize, size[0]);
    part.Height = std::min(windowSize, size[1]);
    part.Column = static_cast<int>(at[0] * (size[0] - part.Width));
    part.Row = static_cast<int>(at[1] * (size[1] - part.Height));
    parts.push_back(part);
  }
  double range[2] = { std::numeric_limits<double>::infinity(),
    -std::numeric_limits<double>::infinity() };
  for (const SampleWindow& part : parts)
  {
    std::vector<double> samples(part.GetNumberOfSamples());
    std::string ignored; // the index or a query reports it
    if (file.Read(part, samples.data(), ignored))
    {
      for (const double sample : samples)
      {
        range[0] = sample < range[0] ? sample : range[0];
        range[1] = sample > range[1] ? sample : range[1];
      }
    }
  }
  if (range[0] > range[1])
  {
    return { { 0.0, 0.0 } };
  }
  const RasterDescription& contents = file.Describe();
  const double first = contents.Scale * range[0] + contents.Offset;
  const double second = contents.Scale * range[1] + contents.Offset;
  return { { std::min(first, second), std::max(first, second) } };
}

double GetSampleDistance(const RasterDescription& contents)
{
  const Georeference& location = contents.Location;
  double unit = location.Unit / contents.VerticalUnit;
  double shrink = 1.0; // of a degree of longitude
  if (location.System == Georeference::Kind::Geographic)
  {
    const double radian = std::atan(1.0) / 45.0;
    unit *= radian * location.SemiMajorAxis;
    shrink = std::cos(radian * location.Unit * location.Coordinates(0.5, 0.5)[1]);
  }
  else if (location.System != Georeference::Kind::Planar)
  {
    return 1.0;
  }
  const double column =
    std::hypot(shrink * location.AlongU[0], location.AlongU[1]) / contents.Width;
  const double row = std::hypot(shrink * location.AlongV[0], location.AlongV[1]) / contents.Height;
  const double distance = 0.5 * (column + row) * unit;
  return std::isfinite(distance) && distance > 0.0 ? distance : 1.0;
}
}
