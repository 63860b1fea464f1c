// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Warp/WarpPasses.h"

#include "Warp/WarpColumns.h"
#include "Warp/WarpSource.h"

#include "vtkMultiThreader.h"
#include "vtkNew.h"

#include <algorithm>
#include <atomic>
#include <utility>

namespace relevo
{
void WarpPasses::Allocate(const WarpSource& source, Policy way, int numberOfThreads)
{
  const int width = source.GetWidth();
  const int height = source.GetHeight();
  this->ThePolicy = way;
  this->NumberOfThreads = way == Policy::OneThread ? 1 : numberOfThreads;
  const bool isByColumns = way == Policy::RowsAndColumns;
  this->Bands.resize(isByColumns ? 0 : this->NumberOfThreads);
  for (size_t i = 0; i < this->Bands.size(); ++i)
  {
    Band& band = this->Bands[i];
    band.Rows[0].Allocate(width);
    band.Rows[1].Allocate(width);
    band.Strip.Allocate(width);
    band.IsJoined.resize(width);
    if (i > 0) // the first band draws to the result
    {
      band.Picture.Allocate(source.GetRelief());
    }
  }
  this->Rows.resize(isByColumns ? height : 0);
  this->Strips.resize(isByColumns ? height : 0);
  this->IsJoined.resize(isByColumns ? width : 0);
  for (int row = 0; row < static_cast<int>(this->Rows.size()); ++row)
  {
    this->Rows[row].Allocate(width);
    this->Strips[row].Allocate(width);
  }
}

void WarpPasses::Warp(
  const WarpSource& source, const WarpCoefficients& coefficients, WarpPicture& picture)
{
  picture.Begin(source.GetRelief());
  if (coefficients.IsUsable && this->ThePolicy == Policy::OneThread)
  {
    this->WarpRows(source, coefficients, picture, this->Bands[0], 0, source.GetHeight());
  }
  else if (coefficients.IsUsable && this->ThePolicy == Policy::Bands)
  {
    this->WarpBands(source, coefficients, picture);
  }
  else if (coefficients.IsUsable)
  {
    this->WarpRowsAndColumns(source, coefficients, picture);
  }
  this->RunAll(source.GetHeight(), 16,
    [&](int first, int end)
    {
      for (int row = first; row < end; ++row)
      {
        for (size_t i = 1; coefficients.IsUsable && i < this->Bands.size(); ++i)
        {
          picture.Merge(this->Bands[i].Picture, row);
        }
        picture.Finish(row);
      }
    });
}

void WarpPasses::WarpRows(const WarpSource& source, const WarpCoefficients& coefficients,
  WarpPicture& picture, Band& band, int first, int end)
{
  const int width = source.GetWidth();
  WarpColumns columns(source, coefficients, picture);
  WarpRow* lower = &band.Rows[0];
  WarpRow* upper = &band.Rows[1];
  unsigned char* isJoined = band.IsJoined.data();
  std::fill_n(isJoined, width, static_cast<unsigned char>(0));
  if (first >= end)
  {
    return;
  }
  if (first > 0)
  {
    // Repeat the end of the previous band, so that nothing is drawn twice.
    lower->Warp(source, coefficients, first - 1);
    upper->Warp(source, coefficients, first);
    band.Strip.Compare(source, first - 1, *lower, *upper);
    for (int position = 0; position < width; ++position)
    {
      isJoined[position] = band.Strip.AreJoined(source, first - 1, *lower, *upper, position);
    }
    std::swap(lower, upper);
  }
  else
  {
    lower->Warp(source, coefficients, first);
  }
  for (int row = first; row < end; ++row)
  {
    if (row + 1 == source.GetHeight())
    {
      columns.WarpLast(row, *lower, isJoined, 0, width);
      break;
    }
    upper->Warp(source, coefficients, row + 1);
    band.Strip.Compare(source, row, *lower, *upper);
    columns.Warp(row, *lower, *upper, band.Strip, isJoined, 0, width);
    std::swap(lower, upper);
  }
}

void WarpPasses::WarpBands(
  const WarpSource& source, const WarpCoefficients& coefficients, WarpPicture& picture)
{
  const int number = static_cast<int>(this->Bands.size());
  const auto findRow = [&](int band)
  {
    return band == number ? source.GetHeight() : source.FindRow(static_cast<double>(band) / number);
  };
  this->RunAll(number, 1,
    [&](int first, int end)
    {
      for (int i = first; i < end; ++i)
      {
        WarpPicture& own = i == 0 ? picture : this->Bands[i].Picture;
        if (i > 0)
        {
          own.Begin(source.GetRelief());
        }
        this->WarpRows(source, coefficients, own, this->Bands[i], findRow(i), findRow(i + 1));
      }
    });
}

void WarpPasses::WarpRowsAndColumns(
  const WarpSource& source, const WarpCoefficients& coefficients, WarpPicture& picture)
{
  const int height = source.GetHeight();
  const int width = source.GetWidth();
  this->RunAll(height, 16,
    [&](int first, int end)
    {
      for (int row = first; row < end; ++row)
      {
        this->Rows[row].Warp(source, coefficients, row);
        picture.Clear(row);
      }
    });
  this->RunAll(height - 1, 16,
    [&](int first, int end)
    {
      for (int row = first; row < end; ++row)
      {
        this->Strips[row].Compare(source, row, this->Rows[row], this->Rows[row + 1]);
      }
    });
  std::fill(this->IsJoined.begin(), this->IsJoined.end(), static_cast<unsigned char>(0));
  this->RunAll(width, std::max(64, width / (4 * this->NumberOfThreads)),
    [&](int first, int end)
    {
      WarpColumns columns(source, coefficients, picture);
      for (int row = 0; row + 1 < height; ++row)
      {
        columns.Warp(row, this->Rows[row], this->Rows[row + 1], this->Strips[row],
          this->IsJoined.data(), first, end);
      }
      columns.WarpLast(height - 1, this->Rows[height - 1], this->IsJoined.data(), first, end);
    });
}

// Executes parts of the range [0, number) in any available thread. There may be fewer threads than
// requested, because of vtkMultiThreader::SetGlobalMaximumNumberOfThreads().
void WarpPasses::RunAll(
  int number, int step, const std::function<void(int first, int end)>& work) const
{
  if (this->NumberOfThreads == 1)
  {
    work(0, number);
    return;
  }
  std::atomic<int> next(0);
  std::function<void()> run = [&]
  {
    for (int first = next.fetch_add(step); first < number; first = next.fetch_add(step))
    {
      work(first, std::min(first + step, number));
    }
  };
  vtkNew<vtkMultiThreader> threader;
  threader->SetNumberOfThreads(this->NumberOfThreads);
  threader->SetSingleMethod(
    [](void* data) -> VTK_THREAD_RETURN_TYPE
    {
      (*static_cast<std::function<void()>*>(
        static_cast<vtkMultiThreader::ThreadInfo*>(data)->UserData))();
      return VTK_THREAD_RETURN_VALUE;
    },
    &run);
  threader->SingleMethodExecute();
}
}
