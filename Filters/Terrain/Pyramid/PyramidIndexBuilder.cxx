// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Pyramid/PyramidIndexBuilder.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>
#include <system_error>
#include <thread>

namespace relevo
{
namespace
{
constexpr int SamplesPerBlock = 1 << 20; // of absent ones
constexpr int MostAreasPerBlock = 8;
// That a thread needs: the reference, the heights of all levels and two grids of a level.
constexpr std::int64_t BytesPerArea =
  std::int64_t(24) * BlockErrorBuilder::SamplesPerArea * BlockErrorBuilder::SamplesPerArea;

// Where the corners lie along one axis: between two samples of each of the two levels.
struct Corner
{
  int Fine[2]; // positions in the windows
  int Coarse[2];
  double FineWeight; // of the second sample
  double CoarseWeight;
  int FirstTile; // of the coarse level; both, for a point on the border between two
  int LastTile;
};

// Positions in samples of a level of full resolution, and of one that is coarser by a ratio.
double ToCoarse(double x, double ratio)
{
  return (x + 0.5) / ratio - 0.5;
}

double ToFine(double u, double ratio)
{
  return (u + 0.5) * ratio - 0.5;
}

// The corners from sample `first` to sample `last` of level 0.
std::vector<Corner> FindCorners(
  int fineFirst, int fineLast, int fineSize, int coarseFirst, int coarseLast, int coarseSize)
{
  const double ratio = static_cast<double>(fineSize) / coarseSize;
  std::vector<std::pair<double, double>> places; // x in fine samples, u in coarse ones
  for (int x = fineFirst; x <= fineLast; ++x)
  {
    places.emplace_back(x, std::clamp(ToCoarse(x, ratio), 0.0, coarseSize - 1.0));
  }
  for (int u = coarseFirst; u <= coarseLast; ++u)
  {
    const double x = ToFine(u, ratio);
    if (x > fineFirst && x < fineLast)
    {
      places.emplace_back(x, u);
    }
  }
  std::sort(places.begin(), places.end());
  std::vector<Corner> corners;
  corners.reserve(places.size());
  const auto split = [](double position, int first, int samples[2], double& weight)
  {
    const double floor = std::floor(position);
    weight = position - floor;
    samples[0] = static_cast<int>(floor) - first;
    samples[1] = samples[0] + (weight > 0.0 ? 1 : 0); // a sample of weight 0 may lack data
  };
  for (const auto& [x, u] : places)
  {
    Corner corner;
    split(x, fineFirst, corner.Fine, corner.FineWeight);
    split(u, coarseFirst, corner.Coarse, corner.CoarseWeight);
    const int sample = static_cast<int>(std::floor(u));
    corner.LastTile = sample / PyramidIndex::TileSize;
    corner.FirstTile =
      u == sample && sample > 0 ? (sample - 1) / PyramidIndex::TileSize : corner.LastTile;
    corners.push_back(corner);
  }
  return corners;
}

double Interpolate(double a, double b, double weight)
{
  return weight > 0.0 ? a + weight * (b - a) : a;
}
}

PyramidIndexBuilder::PyramidIndexBuilder(const PyramidFile& file, const std::atomic<bool>& abort)
  : File(file)
  , Abort(abort)
  , Blocks(file)
{
}

// Files that store whole rows are read in wide blocks. All blocks consist of areas.
void PyramidIndexBuilder::ChooseBlockSize(int numberOfThreads)
{
  constexpr int area = BlockErrorBuilder::SamplesPerArea;
  int areas = this->File.HasRowBlocks() ? MostAreasPerBlock : 1;
  if (this->MemoryLimit > 0)
  {
    const std::int64_t share = this->MemoryLimit / numberOfThreads;
    areas = static_cast<int>(std::clamp<std::int64_t>(share / BytesPerArea, 1, areas));
  }
  this->BlockSize = { { areas * area, area } };
}

SampleWindow PyramidIndexBuilder::GetLevelWindow(const SampleWindow& block, int level) const
{
  const auto find = [&](int axis, int first, int count, int& begin, int& number)
  {
    const int size = this->File.GetSize(level)[axis];
    const double ratio = static_cast<double>(this->File.GetSize(0)[axis]) / size;
    const auto clampSample = [size](double u) { return std::clamp(u, 0.0, size - 1.0); };
    begin = static_cast<int>(std::floor(clampSample(ToCoarse(first, ratio))));
    const int end = static_cast<int>(std::ceil(clampSample(ToCoarse(first + count - 1, ratio))));
    number = end - begin + 1;
  };
  SampleWindow window;
  window.Level = level;
  find(0, block.Column, block.Width, window.Column, window.Width);
  find(1, block.Row, block.Height, window.Row, window.Height);
  return window;
}

// Splits a window at a multiple of a size, across its longer side.
std::pair<SampleWindow, SampleWindow> PyramidIndexBuilder::Split(
  const SampleWindow& part, int width, int height)
{
  const int columns = (part.Width + width - 1) / width;
  const int rows = (part.Height + height - 1) / height;
  std::pair<SampleWindow, SampleWindow> halves(part, part);
  if (columns > rows)
  {
    halves.first.Width = (columns / 2) * width;
    halves.second.Column += halves.first.Width;
    halves.second.Width -= halves.first.Width;
  }
  else
  {
    halves.first.Height = (rows / 2) * height;
    halves.second.Row += halves.first.Height;
    halves.second.Height -= halves.first.Height;
  }
  return halves;
}

void PyramidIndexBuilder::CollectBlocks(const SampleWindow& part)
{
  if (this->Abort)
  {
    return;
  }
  // Each block also has the first column and row of the next.
  const std::array<int, 2>& size = this->File.GetSize(0);
  SampleWindow block = part;
  block.Width += part.Column + part.Width < size[0] ? 1 : 0;
  block.Height += part.Row + part.Height < size[1] ? 1 : 0;
  if (this->File.IsAbsent(block))
  {
    const double absent = this->File.GetAbsentSample();
    this->Index->AddAbsent(absent);
    for (int level = 1; !std::isnan(absent) && level < this->File.GetNumberOfLevels(); ++level)
    {
      this->CollectConstants(block, level);
    }
  }
  else if (part.Width <= this->BlockSize[0] && part.Height <= this->BlockSize[1])
  {
    this->Jobs.push_back({ Task::Compare, block });
  }
  else
  {
    const auto [first, second] = Split(part, this->BlockSize[0], this->BlockSize[1]);
    this->CollectBlocks(first);
    this->CollectBlocks(second);
  }
}

void PyramidIndexBuilder::CollectRanges(const SampleWindow& part)
{
  constexpr int size = 4 * PyramidIndex::TileSize;
  if (this->Abort || this->File.IsAbsent(part))
  {
    return;
  }
  if (part.Width <= size && part.Height <= size)
  {
    this->Jobs.push_back({ Task::Measure, part });
    return;
  }
  const auto [first, second] = Split(part, size, size);
  this->CollectRanges(first);
  this->CollectRanges(second);
}

void PyramidIndexBuilder::CollectConstants(const SampleWindow& part, int level)
{
  const SampleWindow window = this->GetLevelWindow(part, level);
  if (this->Abort || this->File.IsAbsent(window))
  {
    return;
  }
  if (window.GetNumberOfSamples() <= SamplesPerBlock || part.Width + part.Height <= 2)
  {
    this->Jobs.push_back({ Task::Constant, window });
    return;
  }
  const auto [first, second] = Split(part, 1, 1);
  this->CollectConstants(first, level);
  this->CollectConstants(second, level);
}

bool PyramidIndexBuilder::Build(int numberOfThreads, PyramidIndex& index, std::string& error)
{
  this->Index = &index;
  if (this->MemoryLimit > 0)
  {
    numberOfThreads = static_cast<int>(
      std::clamp<std::int64_t>(this->MemoryLimit / BytesPerArea, 1, numberOfThreads));
  }
  this->ChooseBlockSize(numberOfThreads);
  for (int level = 0; level < this->File.GetNumberOfLevels(); ++level)
  {
    const std::array<int, 2>& size = this->File.GetSize(level);
    const SampleWindow all = { level, 0, 0, size[0], size[1] };
    level == 0 ? this->CollectBlocks(all) : this->CollectRanges(all);
  }
  this->RunJobs(numberOfThreads);
  // Coarser levels can have data near absent samples.
  for (const SampleWindow& window : this->Blocks.GetRequestedAreas())
  {
    if (this->File.IsAbsent(window))
    {
      this->Jobs.push_back({ Task::Compare, window });
    }
  }
  this->RunJobs(numberOfThreads);
  if (!this->HasEnded && !this->Abort)
  {
    index.SetBlockErrors(this->Blocks.Finish(this->Abort, this->Error));
    this->HasEnded = !this->Error.empty() && (this->File.IsVirtual() || this->File.HasChanged());
  }
  error = this->Error;
  return !this->HasEnded && !this->Abort;
}

void PyramidIndexBuilder::RunJobs(int numberOfThreads)
{
  this->NumberOfJobs = this->Jobs.size();
  std::vector<std::thread> threads;
  try
  {
    for (int i = 1; i < numberOfThreads; ++i)
    {
      threads.emplace_back([this]() { this->Work(); });
    }
  }
  catch (const std::system_error&)
  {
    // The system allows no more threads; those that run do the work.
  }
  this->Work();
  for (std::thread& thread : threads)
  {
    thread.join();
  }
  this->Next = this->Jobs.size();
}

double PyramidIndexBuilder::GetProgress() const
{
  const std::size_t number = this->NumberOfJobs;
  return number == 0 ? 0.0 : static_cast<double>(this->Done) / static_cast<double>(number);
}

void PyramidIndexBuilder::Work()
{
  for (std::size_t i = this->Next++; i < this->Jobs.size() && !this->IsStopped(); i = this->Next++)
  {
    try
    {
      this->Run(this->Jobs[i]);
    }
    catch (const std::bad_alloc&)
    {
      this->Stop("there is not enough memory to index the raster");
      return;
    }
    ++this->Done;
  }
}

// Ends the build without an index.
void PyramidIndexBuilder::Stop(const std::string& error)
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  this->Error = this->HasEnded ? this->Error : error;
  this->HasEnded = true;
}

void PyramidIndexBuilder::Run(const Job& job)
{
  if (job.What == Task::Compare)
  {
    this->CompareBlock(job.Window);
    return;
  }
  std::vector<double> samples;
  this->Read(job.Window, samples);
  job.What == Task::Measure ? this->MeasureRange(job.Window, samples)
                            : this->MeasureConstant(job.Window, samples);
}

// Reads a window. If that fails, reads its tiles one by one, so that only the defective ones lack
// data.
void PyramidIndexBuilder::Read(const SampleWindow& window, std::vector<double>& samples)
{
  samples.resize(window.GetNumberOfSamples());
  std::string error;
  if (this->File.Read(window, samples.data(), error))
  {
    return;
  }
  // A file that has changed has no more samples, and a server may have failed for all of them.
  if (this->File.IsVirtual() || this->File.HasChanged())
  {
    this->Stop(error);
    return;
  }
  std::fill(samples.begin(), samples.end(), std::numeric_limits<double>::quiet_NaN());
  constexpr int size = PyramidIndex::TileSize;
  const int end[2] = { window.Column + window.Width, window.Row + window.Height };
  std::vector<double> part;
  SampleWindow tile = window;
  for (tile.Row = window.Row; tile.Row < end[1]; tile.Row += tile.Height)
  {
    tile.Height = std::min((tile.Row / size + 1) * size, end[1]) - tile.Row;
    for (tile.Column = window.Column; tile.Column < end[0]; tile.Column += tile.Width)
    {
      tile.Width = std::min((tile.Column / size + 1) * size, end[0]) - tile.Column;
      part.resize(tile.GetNumberOfSamples());
      if (this->IsStopped() || !this->File.Read(tile, part.data(), error))
      {
        continue;
      }
      for (int row = 0; row < tile.Height; ++row)
      {
        std::copy_n(&part[static_cast<std::size_t>(row) * tile.Width], tile.Width,
          &samples[static_cast<std::size_t>(tile.Row - window.Row + row) * window.Width +
            tile.Column - window.Column]);
      }
    }
  }
  const std::lock_guard<std::mutex> lock(this->Mutex);
  this->Error = this->Error.empty() ? error : this->Error;
}

void PyramidIndexBuilder::CompareBlock(const SampleWindow& block)
{
  const std::unique_ptr<BlockErrorArea> area = this->CompareLevels(block);
  if (area && !this->IsStopped())
  {
    this->Blocks.Add(*area);
  }
}

// Returns the area of a block with its heights on all levels, if it has blocks of the bisection.
// The area holds the only copy of the samples, to limit the memory of a thread.
std::unique_ptr<BlockErrorArea> PyramidIndexBuilder::CompareLevels(const SampleWindow& block)
{
  // A raster of one row or column has no blocks.
  std::unique_ptr<BlockErrorArea> area =
    block.Width > 1 && block.Height > 1 ? BlockErrorBuilder::NewArea(block) : nullptr;
  std::vector<double> narrow;
  std::vector<double>& fine = area ? area->GetReference().Values : narrow;
  this->Read(block, fine);
  this->MeasureRange(block, fine);
  if (area)
  {
    this->Blocks.SetSamples(*area, block, fine);
  }
  std::vector<double> coarse;
  for (int level = 1; level < this->File.GetNumberOfLevels() && !this->IsStopped(); ++level)
  {
    const SampleWindow window = this->GetLevelWindow(block, level);
    this->Read(window, coarse);
    this->MeasureDeviation(block, fine, window, coarse);
    if (area)
    {
      this->Blocks.SetSamples(*area, window, coarse);
    }
  }
  if (area)
  {
    this->Blocks.ScaleReference(*area);
  }
  return area;
}

void PyramidIndexBuilder::MeasureRange(
  const SampleWindow& window, const std::vector<double>& samples)
{
  constexpr int size = PyramidIndex::TileSize;
  const int lastColumn = window.Column + window.Width;
  const int lastRow = window.Row + window.Height;
  for (int tileRow = window.Row / size; tileRow * size < lastRow; ++tileRow)
  {
    for (int tileColumn = window.Column / size; tileColumn * size < lastColumn; ++tileColumn)
    {
      double minimum = std::numeric_limits<double>::infinity();
      double maximum = -minimum;
      for (int y = std::max(tileRow * size, window.Row);
           y < std::min((tileRow + 1) * size, lastRow); ++y)
      {
        const double* row = &samples[static_cast<std::size_t>(y - window.Row) * window.Width];
        const int begin = std::max(tileColumn * size, window.Column) - window.Column;
        const int end = std::min((tileColumn + 1) * size, lastColumn) - window.Column;
        for (int x = begin; x < end; ++x)
        {
          minimum = row[x] < minimum ? row[x] : minimum; // false for NaN
          maximum = row[x] > maximum ? row[x] : maximum;
        }
      }
      const std::lock_guard<std::mutex> lock(this->Mutex);
      this->Index->AddRange(window.Level, tileColumn, tileRow, minimum, maximum);
    }
  }
}

void PyramidIndexBuilder::MeasureDeviation(const SampleWindow& block,
  const std::vector<double>& fine, const SampleWindow& window, const std::vector<double>& coarse)
{
  const std::array<int, 2>& fineSize = this->File.GetSize(0);
  const std::array<int, 2>& coarseSize = this->File.GetSize(window.Level);
  const std::vector<Corner> columns = FindCorners(block.Column, block.Column + block.Width - 1,
    fineSize[0], window.Column, window.Column + window.Width - 1, coarseSize[0]);
  const std::vector<Corner> rows = FindCorners(block.Row, block.Row + block.Height - 1, fineSize[1],
    window.Row, window.Row + window.Height - 1, coarseSize[1]);
  const int firstTileColumn = columns.front().FirstTile;
  const int firstTileRow = rows.front().FirstTile;
  const int tileColumns = columns.back().LastTile - firstTileColumn + 1;
  const int tileRows = rows.back().LastTile - firstTileRow + 1;
  std::vector<double> largest(static_cast<std::size_t>(tileColumns) * tileRows, -1.0);
  std::vector<double> fineRow(block.Width);
  std::vector<double> coarseRow(window.Width);
  for (const Corner& row : rows)
  {
    const auto interpolateRow = [](const std::vector<double>& samples, const int pair[2],
                                  double weight, std::vector<double>& result)
    {
      const double* first = &samples[pair[0] * result.size()];
      const double* second = &samples[pair[1] * result.size()];
      for (std::size_t i = 0; i < result.size(); ++i)
      {
        result[i] = Interpolate(first[i], second[i], weight);
      }
    };
    interpolateRow(fine, row.Fine, row.FineWeight, fineRow);
    interpolateRow(coarse, row.Coarse, row.CoarseWeight, coarseRow);
    double* first = &largest[static_cast<std::size_t>(row.FirstTile - firstTileRow) * tileColumns];
    double* second = &largest[static_cast<std::size_t>(row.LastTile - firstTileRow) * tileColumns];
    for (const Corner& column : columns)
    {
      const double difference = std::abs(
        Interpolate(fineRow[column.Fine[0]], fineRow[column.Fine[1]], column.FineWeight) -
        Interpolate(coarseRow[column.Coarse[0]], coarseRow[column.Coarse[1]], column.CoarseWeight));
      for (double* tiles : { first, second })
      {
        for (int tile : { column.FirstTile, column.LastTile })
        {
          double& known = tiles[tile - firstTileColumn];
          known = difference > known ? difference : known; // false for NaN
        }
      }
    }
  }
  const std::lock_guard<std::mutex> lock(this->Mutex);
  for (int row = 0; row < tileRows; ++row)
  {
    for (int column = 0; column < tileColumns; ++column)
    {
      const double deviation = largest[static_cast<std::size_t>(row) * tileColumns + column];
      if (deviation >= 0.0)
      {
        this->Index->AddDeviation(
          window.Level, firstTileColumn + column, firstTileRow + row, deviation);
      }
    }
  }
}
// Between samples, a bilinear surface differs from a constant by no more than at a sample.
void PyramidIndexBuilder::MeasureConstant(
  const SampleWindow& window, const std::vector<double>& samples)
{
  const double constant = this->File.GetAbsentSample();
  for (int row = 0; row < window.Height; ++row)
  {
    for (int column = 0; column < window.Width; ++column)
    {
      const double deviation =
        std::abs(samples[static_cast<std::size_t>(row) * window.Width + column] - constant);
      if (deviation > 0.0)
      {
        const int x = window.Column + column;
        const int y = window.Row + row;
        this->Blocks.RequestAreas(window.Level, x, y);
        constexpr int size = PyramidIndex::TileSize;
        const std::lock_guard<std::mutex> lock(this->Mutex);
        for (int tileRow = std::max(0, y - 1) / size; tileRow <= y / size; ++tileRow)
        {
          for (int tileColumn = std::max(0, x - 1) / size; tileColumn <= x / size; ++tileColumn)
          {
            this->Index->AddDeviation(window.Level, tileColumn, tileRow, deviation);
          }
        }
      }
    }
  }
}
}
