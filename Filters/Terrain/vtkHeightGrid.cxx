// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeightGrid.h"

#include "vtkNoDataFill.h"
#include "vtkSMPTools.h"
#include "vtkType.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>
#include <type_traits>

namespace relevo
{
namespace
{
// A no-data value in the samples' own type: a declared -3.4e38 is the float nearest to it.
template <typename T>
struct NoDataValues
{
  std::vector<T> Values;
  bool NotANumber = false;

  explicit NoDataValues(const std::vector<double>& declared)
  {
    for (double value : declared)
    {
      if (std::isnan(value))
      {
        this->NotANumber = true;
      }
      else if (std::is_floating_point<T>::value)
      {
        // GDAL clamps what lies beyond the type's range as well.
        const double largest = static_cast<double>(std::numeric_limits<T>::max());
        this->Values.push_back(
          static_cast<T>(std::isinf(value) ? value : std::clamp(value, -largest, largest)));
      }
      // Compared as doubles: the largest 64 bit integers round up to 2^63 and 2^64.
      else if (value >= static_cast<double>(std::numeric_limits<T>::lowest()) &&
        value < static_cast<double>(std::numeric_limits<T>::max()) + 1.0 &&
        value == std::floor(value))
      {
        this->Values.push_back(static_cast<T>(value));
      }
    }
  }

  bool Contain(T sample) const
  {
    return (this->NotANumber && sample != sample) ||
      std::find(this->Values.begin(), this->Values.end(), sample) != this->Values.end();
  }
};
}

HeightGrid::RowStatistics::RowStatistics()
  : Range{ std::numeric_limits<double>::max(), std::numeric_limits<double>::lowest() }
{
}

void HeightGrid::RowStatistics::Add(const RowStatistics& later)
{
  this->Range[0] = std::min(this->Range[0], later.Range[0]);
  this->Range[1] = std::max(this->Range[1], later.Range[1]);
  this->NumberOfInvalid += later.NumberOfInvalid;
  if (this->NumberOfNonFinite == 0)
  {
    std::copy_n(later.FirstNonFinite, 2, this->FirstNonFinite);
  }
  this->NumberOfNonFinite += later.NumberOfNonFinite;
}

bool HeightGrid::Allocate(int width, int height, const Reading& reading, std::string& error)
{
  this->Width = width;
  this->Height = height;
  this->How = reading;
  this->Statistics = RowStatistics();
  const std::size_t size = static_cast<std::size_t>(width) * height;
  // Not cleared: a false size in a broken file costs nothing until its rows are read.
  this->Samples.reset(new (std::nothrow) float[size]);
  this->Validity.reset(
    reading.HasMask || !reading.NoData.empty() ? new (std::nothrow) unsigned char[size] : nullptr);
  if (!this->Samples || (!this->Validity && (reading.HasMask || !reading.NoData.empty())))
  {
    error = "no memory for " + std::to_string(width) + " x " + std::to_string(height) + " heights";
    return false;
  }
  return true;
}

template <typename T>
HeightGrid::RowStatistics HeightGrid::SetRow(
  int row, const T* samples, int stride, const unsigned char* mask)
{
  RowStatistics statistics;
  const NoDataValues<T> noData(this->How.NoData);
  const bool scaled = this->How.Scale != 1.0 || this->How.Offset != 0.0;
  const std::size_t start =
    static_cast<std::size_t>(this->How.FlipRows ? this->Height - 1 - row : row) * this->Width;
  for (int column = 0; column < this->Width; ++column)
  {
    const T sample = samples[static_cast<std::size_t>(column) * stride];
    const std::size_t index = start + (this->How.FlipColumns ? this->Width - 1 - column : column);
    const bool valid = !(mask && !mask[column]) && !noData.Contain(sample);
    if (this->Validity)
    {
      this->Validity[index] = valid;
    }
    if (!valid)
    {
      this->Samples[index] = 0.0f;
      ++statistics.NumberOfInvalid;
      continue;
    }
    const float height = scaled
      ? static_cast<float>(static_cast<double>(sample) * this->How.Scale + this->How.Offset)
      : static_cast<float>(sample);
    this->Samples[index] = height;
    if (!std::isfinite(height))
    {
      if (statistics.NumberOfNonFinite++ == 0)
      {
        statistics.FirstNonFinite[0] = column;
        statistics.FirstNonFinite[1] = row;
      }
      continue;
    }
    statistics.Range[0] = std::min<double>(statistics.Range[0], height);
    statistics.Range[1] = std::max<double>(statistics.Range[1], height);
  }
  return statistics;
}

void HeightGrid::SetRows(
  int first, int count, int type, const void* samples, int stride, const unsigned char* mask)
{
  std::vector<RowStatistics> statistics(count);
  vtkSMPTools::For(0, count,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        const std::size_t start = static_cast<std::size_t>(i) * this->Width;
        const unsigned char* rowMask = mask ? mask + start : nullptr;
        const int row = first + static_cast<int>(i);
        switch (type)
        {
          vtkTemplateMacro(
            statistics[i] = this->SetRow(
              row, static_cast<const VTK_TT*>(samples) + start * stride, stride, rowMask));
          default:
            break;
        }
      }
    });
  for (const RowStatistics& row : statistics)
  {
    this->Statistics.Add(row);
  }
}

bool HeightGrid::Finish(std::string& error)
{
  const RowStatistics& statistics = this->Statistics;
  const long long size = static_cast<long long>(this->Width) * this->Height;
  if (statistics.NumberOfNonFinite > 0)
  {
    error = std::to_string(statistics.NumberOfNonFinite) + " of " + std::to_string(size) +
      " heights are NaN or infinite, the first in column " +
      std::to_string(statistics.FirstNonFinite[0]) + ", row " +
      std::to_string(statistics.FirstNonFinite[1]) +
      "; if they mean that there is no data, say so with SetNoDataValue (NaN, or the infinity)";
    return false;
  }
  if (statistics.NumberOfInvalid == size)
  {
    error = "none of the " + std::to_string(size) + " heights has data";
    return false;
  }
  if (statistics.NumberOfInvalid == 0)
  {
    this->Validity.reset();
  }
  else
  {
    FillNoData(this->Width, this->Height, this->Samples.get(), this->Validity.get());
  }
  return true;
}
}
