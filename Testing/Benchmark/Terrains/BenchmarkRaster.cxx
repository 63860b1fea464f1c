// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkRaster.h"

#include "BenchmarkFractal.h"

#include <gdal.h>
#include <gdal_alg.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

BenchmarkRaster BenchmarkRaster::MakeMountain(int size)
{
  constexpr int realSize = 1201;
  BenchmarkRaster raster;
  const char* folder = std::getenv("RELEVO_TEST_DATA");
  if (size == realSize && folder && raster.Read(std::string(folder) + "/relief/mt_rainier_90m.tif"))
  {
    return raster;
  }
  return MakeFractal(size);
}

BenchmarkRaster BenchmarkRaster::MakeFractal(int size)
{
  BenchmarkRaster raster;
  raster.Width = size;
  raster.Height = size;
  raster.CoordinateSystem = BenchmarkFractal::CoordinateSystem;
  const BenchmarkFractal fractal;
  for (const short sample : fractal.GetSamples({ { 0, 0 } }, size, size))
  {
    raster.Samples.push_back(sample);
  }
  return raster;
}

double BenchmarkRaster::Interpolate(double column, double row) const
{
  const double x = std::clamp(column, 0.0, this->Width - 1.0);
  const double y = std::clamp(row, 0.0, this->Height - 1.0);
  const int i = std::min(static_cast<int>(x), this->Width - 2);
  const int j = std::min(static_cast<int>(y), this->Height - 2);
  const double u = x - i;
  const double v = y - j;
  return (1.0 - v) * ((1.0 - u) * this->GetSample(i, j) + u * this->GetSample(i + 1, j)) +
    v * ((1.0 - u) * this->GetSample(i, j + 1) + u * this->GetSample(i + 1, j + 1));
}

BenchmarkRaster BenchmarkRaster::Crop(int width, int height) const
{
  BenchmarkRaster part = *this;
  part.Width = std::min(width, this->Width);
  part.Height = std::min(height, this->Height);
  part.Samples.clear();
  for (int row = 0; row < part.Height; ++row)
  {
    for (int column = 0; column < part.Width; ++column)
    {
      part.Samples.push_back(this->GetSample(column, row));
    }
  }
  return part;
}

bool BenchmarkRaster::Read(const std::string& fileName)
{
  GDALAllRegister();
  GDALDatasetH file = GDALOpen(fileName.c_str(), GA_ReadOnly);
  if (!file)
  {
    return false;
  }
  this->Width = GDALGetRasterXSize(file);
  this->Height = GDALGetRasterYSize(file);
  this->Samples.resize(static_cast<std::size_t>(this->Width) * this->Height);
  this->CoordinateSystem = GDALGetProjectionRef(file);
  GDALDatasetH copy =
    GDALCreateCopy(GDALGetDriverByName("MEM"), "", file, false, nullptr, nullptr, nullptr);
  GDALRasterBandH band = GDALGetRasterBand(copy, 1);
  this->Real = GDALGetGeoTransform(file, this->Transform.data()) == CE_None &&
    GDALFillNodata(band, nullptr, 100.0, 0, 0, nullptr, nullptr, nullptr) == CE_None &&
    GDALRasterIO(band, GF_Read, 0, 0, this->Width, this->Height, this->Samples.data(), this->Width,
      this->Height, GDT_Float32, 0, 0) == CE_None;
  GDALClose(copy);
  GDALClose(file);
  return this->Real;
}

bool BenchmarkRaster::Write(const std::string& fileName) const
{
  GDALAllRegister();
  GDALDatasetH file = GDALCreate(GDALGetDriverByName("GTiff"), fileName.c_str(), this->Width,
    this->Height, 1, GDT_Int16, nullptr);
  if (!file)
  {
    return false;
  }
  std::array<double, 6> transform = this->Transform;
  GDALSetGeoTransform(file, transform.data());
  GDALSetProjection(file, this->CoordinateSystem.c_str());
  std::vector<float> samples = this->Samples;
  const bool isWritten =
    GDALRasterIO(GDALGetRasterBand(file, 1), GF_Write, 0, 0, this->Width, this->Height,
      samples.data(), this->Width, this->Height, GDT_Float32, 0, 0) == CE_None;
  GDALClose(file);
  return isWritten;
}
