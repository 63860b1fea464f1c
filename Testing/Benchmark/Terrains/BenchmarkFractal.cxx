// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkFractal.h"

#include <cmath>

const char* const BenchmarkFractal::CoordinateSystem =
  R"(PROJCS["WGS 84 / UTM zone 33N",GEOGCS["WGS 84",DATUM["WGS_1984",)"
  R"(SPHEROID["WGS 84",6378137,298.257223563]],PRIMEM["Greenwich",0],)"
  R"(UNIT["degree",0.0174532925199433]],PROJECTION["Transverse_Mercator"],)"
  R"(PARAMETER["latitude_of_origin",0],PARAMETER["central_meridian",15],)"
  R"(PARAMETER["scale_factor",0.9996],PARAMETER["false_easting",500000],)"
  R"(PARAMETER["false_northing",0],UNIT["metre",1]])";

BenchmarkFractal::BenchmarkFractal()
  : Square(static_cast<std::size_t>(Period) * Period, 0.0f)
{
  float amplitude = 1500.0f;
  for (int step = Period; step > 1; step /= 2, amplitude *= 0.55f)
  {
    this->Divide(step, amplitude);
  }
}

void BenchmarkFractal::Divide(int step, float amplitude)
{
  const auto vary = [&]()
  {
    this->Random = this->Random * 1664525u + 1013904223u;
    return amplitude * (static_cast<float>(this->Random >> 8) / 8388608.0f - 1.0f);
  };
  const int half = step / 2;
  for (int row = 0; row < Period; row += step)
  {
    for (int column = 0; column < Period; column += step)
    {
      this->At(column + half, row + half) = vary() +
        0.25f *
          (this->At(column, row) + this->At(column + step, row) + this->At(column, row + step) +
            this->At(column + step, row + step));
    }
  }
  for (int row = 0; row < Period; row += half)
  {
    for (int column = row % step == 0 ? half : 0; column < Period; column += step)
    {
      this->At(column, row) = vary() +
        0.25f *
          (this->At(column - half, row) + this->At(column + half, row) +
            this->At(column, row - half) + this->At(column, row + half));
    }
  }
}

std::vector<short> BenchmarkFractal::GetSamples(
  std::array<int, 2> first, int width, int height) const
{
  struct Wave
  {
    float Hill;
    float Amplitude;
  };
  const auto getWaves = [](int begin, int size)
  {
    std::vector<Wave> waves;
    for (int i = begin; i < begin + size; ++i)
    {
      waves.push_back({ std::sin(i / 2900.0f + 1.0f), std::cos(i / 1700.0f) });
    }
    return waves;
  };
  const std::vector<Wave> columns = getWaves(first[0], width);
  const std::vector<Wave> rows = getWaves(first[1], height);
  std::vector<short> samples(static_cast<std::size_t>(width) * height);
  for (int j = 0; j < height; ++j)
  {
    const float* square =
      &this->Square[static_cast<std::size_t>((first[1] + j) & (Period - 1)) * Period];
    for (int i = 0; i < width; ++i)
    {
      const float height0 = 2000.0f + 1000.0f * columns[i].Hill * rows[j].Hill;
      const float amplitude = 0.6f + 0.4f * columns[i].Amplitude * rows[j].Amplitude;
      samples[static_cast<std::size_t>(j) * width + i] = static_cast<short>(
        std::lround(height0 + amplitude * square[(first[0] + i) & (Period - 1)]));
    }
  }
  return samples;
}
