// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Lattice/SampleDoubts.h"

#include "vtkType.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <sstream>
#include <vector>

namespace relevo
{
namespace
{
constexpr double HugeNumber = 1e30;
constexpr int LargestWindow = 128; // samples per side, for the variation of bytes
// Mean difference of neighbours, as a share of the range. Coarse heights of mountains have 0.025.
constexpr double LargestVariation = 0.04;

// Whether the bytes in the centre vary from sample to sample.
bool IsNoisy(const HeightLattice& lattice)
{
  const RasterDescription& contents = lattice.Describe();
  const int width = std::min(contents.Width, LargestWindow);
  const int height = std::min(contents.Height, LargestWindow);
  std::vector<float> samples(static_cast<std::size_t>(width) * height);
  std::string error;
  if (!lattice.ReadWindow(0, (contents.Width - width) / 2, (contents.Height - height) / 2, width,
        height, samples.data(), error))
  {
    return false; // other readers report it
  }
  double sum = 0.0;
  int number = 0;
  float lowest = std::numeric_limits<float>::infinity();
  float highest = -lowest;
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    if (!std::isfinite(samples[i]))
    {
      continue;
    }
    lowest = std::min(lowest, samples[i]);
    highest = std::max(highest, samples[i]);
    if (i % width > 0 && std::isfinite(samples[i - 1]))
    {
      sum += std::abs(static_cast<double>(samples[i]) - samples[i - 1]);
      ++number;
    }
  }
  return number > 0 && sum / number > LargestVariation * (highest - lowest);
}
}

bool IsMarker(double sample)
{
  const double size = std::abs(sample);
  if (!(size < HugeNumber))
  {
    return true;
  }
  double nines = 999.0;
  while (nines < size)
  {
    nines = 10.0 * nines + 9.0;
  }
  constexpr std::array<double, 6> ends = { { 32767.0, 32768.0, 65535.0, 2147483647.0, 2147483648.0,
    4294967295.0 } };
  return size == nines || std::find(ends.begin(), ends.end(), size) != ends.end();
}

std::string FindPhotoWarning(const HeightLattice& lattice)
{
  const RasterDescription& contents = lattice.Describe();
  const std::string remedy = " To drape a photo over a terrain, set it as ImageryFileName.";
  if (contents.IsPicture)
  {
    return " has three or more bands of bytes, as photos have. Its first band is read as heights." +
      remedy;
  }
  if (contents.IsJPEG)
  {
    return " is a JPEG file, as photos are. Its grey values are read as heights." + remedy;
  }
  if (contents.Type == VTK_UNSIGNED_CHAR && contents.Location.System == Georeference::Kind::None &&
    IsNoisy(lattice))
  {
    return " has bytes that vary from sample to sample, as photos do. They are read as heights." +
      remedy;
  }
  return "";
}

std::string FindMarkerWarning(const RasterDescription& contents, const std::array<double, 2>& range,
  const float* heights, std::size_t count)
{
  for (const int end : { 0, 1 })
  {
    const double value = range[end];
    const double sample = (value - contents.Offset) / contents.Scale;
    if (!IsMarker(sample))
    {
      continue;
    }
    const double tolerance = 1e-6 * std::abs(value);
    double others[2] = { std::numeric_limits<double>::infinity(),
      -std::numeric_limits<double>::infinity() };
    std::for_each(heights, heights + count,
      [&](double height)
      {
        if (std::isfinite(height) && std::abs(height - value) > tolerance)
        {
          others[0] = std::min(others[0], height);
          others[1] = std::max(others[1], height);
        }
      });
    const double gap = end == 0 ? others[0] - value : value - others[1];
    // A mask has two values, of which the higher one is common.
    const bool isMask = end == 1 && others[0] == others[1];
    if (others[0] <= others[1] && !isMask && gap > others[1] - others[0])
    {
      std::ostringstream text;
      text << std::setprecision(9)
           << (end == 0 ? ": its lowest height, " : ": its highest height, ") << value
           << ", is far from all others, which are from " << std::setprecision(6) << others[0]
           << " to " << others[1]
           << ". If it stands for missing data, declare it (gdal_translate -a_nodata "
           << std::setprecision(9) << sample << ").";
      return text.str();
    }
  }
  return "";
}
}
