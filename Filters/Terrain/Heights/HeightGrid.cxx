// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Heights/HeightGrid.h"

#include "Heights/HeightReduction.h"
#include "Heights/NoDataFill.h"
#include "Raster/StoredNoData.h"
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
// Rows that are reduced in parallel. They need little memory compared with the result.
constexpr int RowsPerPart = 64;

// No-data values converted to the type of the samples: -3.4e38 becomes the nearest float.
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
        this->Values.push_back(GetStoredNoData<T>(value));
      }
      // The largest 64 bit integers round up to 2^63 and 2^64 as double.
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

HeightGrid::HeightGrid() = default;
HeightGrid::~HeightGrid() = default;

bool HeightGrid::Allocate(
  const int source[2], const int size[2], const SampleEncoding& encoding, std::string& error)
{
  std::copy_n(source, 2, this->Source);
  this->Width = size[0];
  this->Height = size[1];
  this->Encoding = encoding;
  this->Statistics = RowStatistics();
  this->Reduction.reset(
    std::equal(source, source + 2, size) ? nullptr : new HeightReduction(source, size));
  const std::size_t number = static_cast<std::size_t>(this->Width) * this->Height;
  // Not cleared, so that a wrong size in a broken file does not allocate pages. Neither do the rows
  // of Validity that have all samples.
  this->Samples.reset(new (std::nothrow) float[number]);
  this->Validity.reset(encoding.HasMask || !encoding.NoData.empty()
      ? new (std::nothrow) unsigned char[number]
      : nullptr);
  this->HasMissing.assign(this->Validity ? this->Height : 0, false);
  if (!this->Samples || (!this->Validity && (encoding.HasMask || !encoding.NoData.empty())))
  {
    error = "not enough memory for " + std::to_string(this->Width) + " x " +
      std::to_string(this->Height) + " heights";
    return false;
  }
  return true;
}

std::size_t HeightGrid::RowStart(int row) const
{
  return static_cast<std::size_t>(this->Encoding.FlipRows ? this->Height - 1 - row : row) *
    this->Width;
}

template <typename T>
HeightGrid::RowStatistics HeightGrid::Decode(int row, const T* samples, int stride,
  const unsigned char* mask, float* heights, unsigned char* validity) const
{
  RowStatistics statistics;
  const NoDataValues<T> noData(this->Encoding.NoData);
  const bool scaled = this->Encoding.Scale != 1.0 || this->Encoding.Offset != 0.0;
  for (int column = 0; column < this->Source[0]; ++column)
  {
    const T sample = samples[static_cast<std::size_t>(column) * stride];
    const bool valid = !(mask && !mask[column]) && !noData.Contain(sample);
    if (validity)
    {
      validity[column] = valid;
    }
    if (!valid)
    {
      heights[column] = 0.0f;
      ++statistics.NumberOfInvalid;
      continue;
    }
    const float height = scaled
      ? static_cast<float>(
          static_cast<double>(sample) * this->Encoding.Scale + this->Encoding.Offset)
      : static_cast<float>(sample);
    heights[column] = height;
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

// `start` is the index of the first sample of the row.
HeightGrid::RowStatistics HeightGrid::Decode(int row, int type, const void* samples,
  std::size_t start, int stride, const unsigned char* mask, float* heights,
  unsigned char* validity) const
{
  switch (type)
  {
    vtkTemplateMacro(return this->Decode(row, static_cast<const VTK_TT*>(samples) + start * stride,
      stride, mask ? mask + start : nullptr, heights, validity));
    default:
      return RowStatistics();
  }
}

void HeightGrid::SetRows(
  int first, int count, int type, const void* samples, int stride, const unsigned char* mask)
{
  if (this->Reduction)
  {
    this->SetReducedRows(first, count, type, samples, stride, mask);
    return;
  }
  std::vector<RowStatistics> statistics(count);
  vtkSMPTools::For(0, count,
    [&](vtkIdType begin, vtkIdType end)
    {
      std::vector<unsigned char> validity(this->Validity ? this->Width : 0);
      for (vtkIdType i = begin; i < end; ++i)
      {
        const int row = first + static_cast<int>(i);
        const std::size_t start = this->RowStart(row);
        float* heights = this->Samples.get() + start;
        statistics[i] = this->Decode(row, type, samples, static_cast<std::size_t>(i) * this->Width,
          stride, mask, heights, this->Validity ? validity.data() : nullptr);
        if (this->Encoding.FlipColumns)
        {
          std::reverse(heights, heights + this->Width);
          std::reverse(validity.begin(), validity.end());
        }
        if (this->Validity && statistics[i].NumberOfInvalid > 0)
        {
          std::copy(validity.begin(), validity.end(), this->Validity.get() + start);
          this->HasMissing[start / this->Width] = true;
        }
      }
    });
  for (const RowStatistics& row : statistics)
  {
    this->Statistics.Add(row);
  }
}

void HeightGrid::SetReducedRows(
  int first, int count, int type, const void* samples, int stride, const unsigned char* mask)
{
  std::vector<RowStatistics> statistics(RowsPerPart);
  const std::size_t width = static_cast<std::size_t>(this->Width);
  std::vector<double> sums(RowsPerPart * width);
  std::vector<double> widths(RowsPerPart * width);
  for (int part = 0; part < count; part += RowsPerPart)
  {
    const int rows = std::min(RowsPerPart, count - part);
    vtkSMPTools::For(0, rows,
      [&](vtkIdType begin, vtkIdType end)
      {
        std::vector<float> heights(this->Source[0]);
        std::vector<unsigned char> validity(this->Validity ? this->Source[0] : 0);
        unsigned char* valid = this->Validity ? validity.data() : nullptr;
        for (vtkIdType i = begin; i < end; ++i)
        {
          const std::size_t start = static_cast<std::size_t>(part + i) * this->Source[0];
          statistics[i] = this->Decode(first + part + static_cast<int>(i), type, samples, start,
            stride, mask, heights.data(), valid);
          this->Reduction->ReduceRow(
            heights.data(), valid, sums.data() + i * width, widths.data() + i * width);
        }
      });
    for (int i = 0; i < rows; ++i)
    {
      // The range and the number of missing heights are computed from the means.
      RowStatistics nonFinite;
      nonFinite.NumberOfNonFinite = statistics[i].NumberOfNonFinite;
      std::copy_n(statistics[i].FirstNonFinite, 2, nonFinite.FirstNonFinite);
      this->Statistics.Add(nonFinite);
      this->Reduction->AddRow(sums.data() + i * width, widths.data() + i * width,
        [this](int row, const double* total, const double* areas)
        { this->SetMeans(row, total, areas); });
    }
  }
}

void HeightGrid::SetMeans(int row, const double* sums, const double* areas)
{
  const std::size_t start = this->RowStart(row);
  if (this->Validity)
  {
    this->HasMissing[start / this->Width] = true;
  }
  for (int column = 0; column < this->Width; ++column)
  {
    const std::size_t index =
      start + (this->Encoding.FlipColumns ? this->Width - 1 - column : column);
    const bool valid = areas[column] > 0.0;
    const float height = valid ? static_cast<float>(sums[column] / areas[column]) : 0.0f;
    this->Samples[index] = height;
    if (valid)
    {
      this->Statistics.Range[0] = std::min<double>(this->Statistics.Range[0], height);
      this->Statistics.Range[1] = std::max<double>(this->Statistics.Range[1], height);
    }
    else
    {
      ++this->Statistics.NumberOfInvalid;
    }
    if (this->Validity)
    {
      this->Validity[index] = valid;
    }
  }
}

bool HeightGrid::Finish(std::string& error)
{
  const RowStatistics& statistics = this->Statistics;
  const std::string size =
    std::to_string(static_cast<long long>(this->Source[0]) * this->Source[1]);
  if (statistics.NumberOfNonFinite > 0)
  {
    error = std::to_string(statistics.NumberOfNonFinite) + " of " + size +
      " heights are NaN or infinite, the first in column " +
      std::to_string(statistics.FirstNonFinite[0]) + ", row " +
      std::to_string(statistics.FirstNonFinite[1]) +
      "; if they are missing values, call SetNoDataValue() with that value";
    return false;
  }
  if (statistics.NumberOfInvalid == static_cast<long long>(this->Width) * this->Height)
  {
    error = "all " + size + " heights are missing values; check the no-data value";
    return false;
  }
  if (statistics.NumberOfInvalid == 0)
  {
    this->Validity.reset();
  }
  else
  {
    for (int row = 0; row < this->Height; ++row)
    {
      if (!this->HasMissing[row])
      {
        std::fill_n(
          this->Validity.get() + static_cast<std::size_t>(row) * this->Width, this->Width, 1);
      }
    }
    FillNoData(this->Width, this->Height, this->Samples.get(), this->Validity.get());
  }
  return true;
}
}
