// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Raster/ImageryTransformer.h"

#include <ogr_srs_api.h>

#include <cmath>

namespace relevo
{
namespace
{
constexpr double FullTurn = 2.0 * 3.14159265358979323846; // radians

// Returns 0 for all images but those whose columns are meridians. Sets the rows of the poles.
double FindPeriod(GDALDatasetH image, std::array<double, 2>& poles)
{
  const OGRSpatialReferenceH system = GDALGetSpatialRef(image);
  double transform[6];
  if (!system || !OSRIsGeographic(system) || GDALGetGeoTransform(image, transform) != CE_None ||
    transform[1] == 0.0 || transform[5] == 0.0 || transform[2] != 0.0 || transform[4] != 0.0)
  {
    return 0.0;
  }
  const double unit = OSRGetAngularUnits(system, nullptr);
  for (int i = 0; i < 2; ++i)
  {
    const double latitude = (i == 0 ? 0.25 : -0.25) * FullTurn / unit;
    poles[i] = (latitude - transform[3]) / transform[5];
  }
  return FullTurn / std::abs(unit * transform[1]);
}
}

ImageryTransformer::ImageryTransformer(GDALDatasetH image, GDALDatasetH target)
  : Exact(GDALCreateGenImgProjTransformer2(image, target, nullptr))
  , Period(FindPeriod(image, this->Poles))
  , Middle(0.5 * GDALGetRasterXSize(image))
{
}

double ImageryTransformer::GetNearest(double column, double other) const
{
  // Halves are rounded up, so that a longitude is found once between two ends of a period.
  return this->Period > 0.0
    ? column + this->Period * std::floor((other - column) / this->Period + 0.5)
    : column;
}

bool ImageryTransformer::IsAtPole(double row) const
{
  return this->Period > 0.0 &&
    (std::abs(row - this->Poles[0]) < 1.0 || std::abs(row - this->Poles[1]) < 1.0);
}

int ImageryTransformer::Transform(
  void* self, int toImage, int number, double* x, double* y, double* z, int* success)
{
  const auto& transformer = *static_cast<const ImageryTransformer*>(self);
  const int result =
    GDALGenImgProjTransform(transformer.Exact.get(), toImage, number, x, y, z, success);
  for (int i = 0; i < number && toImage; ++i)
  {
    if (success[i] && std::isfinite(x[i]))
    {
      x[i] = transformer.GetNearest(x[i], transformer.Middle);
    }
  }
  return result;
}

ImageryTransformer::Point ImageryTransformer::ToImage(const std::array<double, 2>& position) const
{
  std::array<double, 2> point = position;
  double z = 0.0;
  int success = 0;
  Transform(const_cast<ImageryTransformer*>(this), 1, 1, &point[0], &point[1], &z, &success);
  return { point, success && std::isfinite(point[0]) && std::isfinite(point[1]) };
}

ImageryTransformer::Point ImageryTransformer::ToTarget(const std::array<double, 2>& position) const
{
  std::array<double, 2> point = position;
  double z = 0.0;
  int success = 0;
  Transform(const_cast<ImageryTransformer*>(this), 0, 1, &point[0], &point[1], &z, &success);
  return { point, success && std::isfinite(point[0]) && std::isfinite(point[1]) };
}
}
