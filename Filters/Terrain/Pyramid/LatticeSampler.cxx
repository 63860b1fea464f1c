// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Pyramid/LatticeSampler.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace relevo
{
namespace
{
// Larger windows are read row by row.
constexpr std::size_t MaximumWindow = std::size_t(1) << 22;

// The overviews of odd sizes are a little coarser than powers of 2.
constexpr double RatioTolerance = 1.01;

// Where the vertices of a lattice lie between the samples of a level, along one axis.
struct Positions
{
  std::vector<int> First;      // samples
  std::vector<double> Weights; // of the samples after them
  int Begin = 0;               // of the samples that are needed
  int End = 0;

  Positions(int level, int first, int number, int fineSize, int size)
  {
    const double ratio = static_cast<double>(fineSize) / size;
    for (int i = 0; i < number; ++i)
    {
      const double x =
        std::clamp(std::ldexp(static_cast<double>(first) + i, level), 0.0, fineSize - 1.0);
      const double u = std::clamp((x + 0.5) / ratio - 0.5, 0.0, size - 1.0);
      this->First.push_back(static_cast<int>(u));
      this->Weights.push_back(u - this->First.back());
    }
    this->Begin = this->First.front();
    this->End = this->First.back() + (this->Weights.back() > 0.0 ? 2 : 1);
  }
};

// Samples without weight may lack data.
double MixSamples(double a, double b, double weight)
{
  return weight > 0.0 ? a + weight * (b - a) : a;
}
}

LatticeSampler::LatticeSampler(const PyramidFile& file)
  : File(file)
{
}

int LatticeSampler::GetPyramidLevel(int level) const
{
  const auto getRatio = [this](int candidate)
  {
    double ratio = 0.0;
    for (int axis = 0; axis < 2; ++axis)
    {
      ratio = std::max(ratio,
        static_cast<double>(this->File.GetSize(0)[axis]) / this->File.GetSize(candidate)[axis]);
    }
    return ratio;
  };
  int found = 0;
  while (found + 1 < this->File.GetNumberOfLevels() &&
    getRatio(found + 1) <= std::ldexp(RatioTolerance, level))
  {
    ++found;
  }
  return found;
}

bool LatticeSampler::Read(
  int level, int column, int row, int width, int height, float* heights, std::string& error) const
{
  return this->File.HasFloatSamples()
    ? this->ReadAs<float>(level, column, row, width, height, heights, error)
    : this->ReadAs<double>(level, column, row, width, height, heights, error);
}

template <typename T>
bool LatticeSampler::ReadAs(
  int level, int column, int row, int width, int height, float* heights, std::string& error) const
{
  const int source = this->GetPyramidLevel(level);
  const std::array<int, 2>& full = this->File.GetSize(0);
  const std::array<int, 2>& size = this->File.GetSize(source);
  const Positions columns(level, column, width, full[0], size[0]);
  const Positions rows(level, row, height, full[1], size[1]);
  SampleWindow window;
  window.Level = source;
  window.Column = columns.Begin;
  window.Width = columns.End - columns.Begin;
  window.Row = rows.Begin;
  window.Height = rows.End - rows.Begin;
  const bool isWhole = window.GetNumberOfSamples() <= MaximumWindow;
  std::vector<T> samples;
  for (int j = 0; j < height; j += isWhole ? height : 1)
  {
    const int number = isWhole ? height : 1;
    if (!isWhole)
    {
      window.Row = rows.First[j];
      window.Height = rows.Weights[j] > 0.0 ? 2 : 1;
    }
    samples.resize(window.GetNumberOfSamples());
    if (!this->File.Read(window, samples.data(), error))
    {
      return false;
    }
    this->InterpolateAs(window, samples.data(), level, column, row + j, width, number,
      heights + static_cast<std::size_t>(j) * width);
  }
  return true;
}

void LatticeSampler::Interpolate(const SampleWindow& window, const double* samples, int level,
  int column, int row, int width, int height, float* heights) const
{
  this->InterpolateAs(window, samples, level, column, row, width, height, heights);
}

template <typename T>
void LatticeSampler::InterpolateAs(const SampleWindow& window, const T* samples, int level,
  int column, int row, int width, int height, float* heights) const
{
  const std::array<int, 2>& full = this->File.GetSize(0);
  const std::array<int, 2>& size = this->File.GetSize(window.Level);
  const Positions columns(level, column, width, full[0], size[0]);
  const Positions rows(level, row, height, full[1], size[1]);
  const RasterDescription& contents = this->File.Describe();
  for (int j = 0; j < height; ++j)
  {
    const T* first = samples + static_cast<std::size_t>(rows.First[j] - window.Row) * window.Width;
    const T* second = rows.Weights[j] > 0.0 ? first + window.Width : first;
    for (int i = 0; i < width; ++i)
    {
      const int a = columns.First[i] - window.Column;
      const int b = columns.Weights[i] > 0.0 ? a + 1 : a;
      const double sample = MixSamples(MixSamples(first[a], first[b], columns.Weights[i]),
        MixSamples(second[a], second[b], columns.Weights[i]), rows.Weights[j]);
      heights[static_cast<std::size_t>(j) * width + i] =
        static_cast<float>(contents.Scale * sample + contents.Offset);
    }
  }
}

bool LatticeSampler::Read(HeightTile& tile, std::string& error) const
{
  tile.Heights.resize(static_cast<std::size_t>(HeightTile::Stride) * HeightTile::Stride);
  return this->Read(tile.Level, HeightTile::CellsPerTile * tile.Column - 1,
    HeightTile::CellsPerTile * tile.Row - 1, HeightTile::Stride, HeightTile::Stride,
    tile.Heights.data(), error);
}
}
