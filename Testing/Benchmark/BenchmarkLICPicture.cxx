// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkLICPicture.h"

#include "BenchmarkFlow.h"
#include "RelevoOrientation.h"

#include <algorithm>
#include <cmath>
#include <limits>

std::vector<double> GetPictureFigures(
  const FlowScene& scene, int width, int height, const std::vector<unsigned char>& picture)
{
  RelevoGrey grey(width, height);
  if (picture.size() != 3 * grey.Values.size())
  {
    return std::vector<double>(4, std::numeric_limits<double>::quiet_NaN());
  }
  for (size_t i = 0; i < grey.Values.size(); ++i)
  {
    grey.Values[i] = picture[3 * i] / 255.0;
  }
  const double pixel = 2.0 / height;
  double sum = 0.0;
  double squares = 0.0;
  const auto angles = MeasureDeviations(RelevoOrientation(grey),
    [&](int column, int row, double vector[2])
    {
      const auto direction = scene.GetDirection(
        (column + 0.5 - 0.5 * width) * pixel, (row + 0.5 - 0.5 * height) * pixel);
      std::copy(direction.begin(), direction.end(), vector);
      if (vector[0] == 0.0 && vector[1] == 0.0)
      {
        return false;
      }
      const double value = grey.At(column, row);
      sum += value;
      squares += value * value;
      return true;
    });
  const auto count = static_cast<double>(angles.Count);
  const double mean = sum / count;
  return { mean, std::sqrt(std::max(squares / count - mean * mean, 0.0)), angles.Median,
    angles.Percentile95 };
}
