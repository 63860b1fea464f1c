// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkWarpSamples.h"

#include "RelevoWarpScenes.h"

#include "vtkCamera.h"
#include "vtkImageData.h"

#include <cmath>
#include <limits>

namespace
{
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

double GetTerrain(double x, double y)
{
  const double height = 0.04 * std::sin(19.0 * x) * std::cos(17.0 * y) +
    0.01 * std::sin(71.0 * x + 13.0 * y) + 0.005 * std::cos(151.0 * y - 37.0 * x);
  const bool isVoid = std::hypot(x - 0.21, y + 0.17) < 0.04;
  return isVoid ? NaN : 0.07 + height;
}

// 9 x 9 columns with round heads in front of a wall with openings.
double GetColumns(double x, double y)
{
  const double across = 9.0 * x - std::floor(9.0 * x) - 0.5;
  const double up = 9.0 * y - std::floor(9.0 * y) - 0.5;
  const double squared = 0.16 - across * across - up * up;
  if (squared > 0.0)
  {
    return 0.09 - 0.2 * std::sqrt(squared);
  }
  return across * across + up * up > 0.36 ? NaN : 0.12;
}

// A bumpy object that covers 54 % of the picture.
double GetObject(double x, double y)
{
  const double squared = 0.172 - x * x - y * y;
  return squared > 0.0
    ? 0.3 - 0.6 * std::sqrt(squared) + 0.01 * std::sin(40.0 * x) * std::sin(37.0 * y)
    : NaN;
}

}

const std::vector<BenchmarkWarpSample>& GetWarpSamples()
{
  static const std::vector<BenchmarkWarpSample> samples = { { "terrain with a void", GetTerrain,
                                                              1.37 },
    { "columns before a wall", GetColumns, 1.25 }, { "object", GetObject, 0.90 } };
  return samples;
}

vtkSmartPointer<vtkImageData> MakeRelief(const BenchmarkWarpSample& sample, int size)
{
  const auto image =
    RelevoMakeRelief(size, size, relevo::ReliefProjection::Parallel, relevo::dmat4(1.0),
      [&](int column, int row)
      { return size * sample.Depth((column + 0.5) / size - 0.5, (row + 0.5) / size - 0.5); });
  RelevoAddWarpNormals(image);
  return image;
}

void MoveCamera(vtkCamera* camera, int size, double step)
{
  const double middle = 0.5 * (size - 1);
  camera->SetFocalPoint(middle, middle, 0.0);
  camera->SetPosition(middle + 0.7 * size * std::sin(0.7 * step),
    middle + 0.55 * size * std::cos(0.7 * step), -2.0 * size);
}
