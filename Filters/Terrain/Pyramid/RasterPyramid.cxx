// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Pyramid/RasterPyramid.h"

#include "Pyramid/Checksum.h"
#include "Pyramid/PyramidIndexBuilder.h"
#include "Pyramid/RasterEstimates.h"
#include "Raster/RasterFile.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <iomanip>
#include <limits>
#include <new>
#include <sstream>
#include <system_error>
#include <vector>
#if defined(__GLIBC__)
#include <malloc.h> // for malloc_trim
#endif

namespace relevo
{
namespace
{
namespace fs = std::filesystem;

// At the center of a sample, other samples do not contribute in spite of rounded coordinates.
constexpr double SnapDistance = 1e-6;

// The folder for caches of the freedesktop.org specification; "" without a home.
std::string FindCacheFolder()
{
  const char* folder = std::getenv("XDG_CACHE_HOME");
  if (folder && folder[0] == '/')
  {
    return std::string(folder) + "/relevo";
  }
  const char* home = std::getenv("HOME");
  return home && home[0] != '\0' ? std::string(home) + "/.cache/relevo" : "";
}

// A file in a cache folder, for rasters of equal names in different folders, too.
std::string MakeCacheFileName(const std::string& folder, const std::string& rasterName)
{
  std::error_code failure;
  const fs::path path = fs::u8path(rasterName);
  const fs::path absolute = fs::exists(path, failure) ? fs::canonical(path, failure) : path;
  const std::uint64_t hash = GetChecksum(absolute.u8string());
  std::ostringstream name;
  name << folder << '/' << path.stem().u8string() << '-' << std::hex << std::setw(16)
       << std::setfill('0') << hash << PyramidIndex::FileExtension;
  return name.str();
}

// A thread that does not end for so long is in a read that hangs.
constexpr std::chrono::seconds LongestWait(5);

// A raster in metres may be declared as longitude and latitude. Rasters with samples on the poles
// reach half a sample beyond them.
std::string FindLatitudeError(const RasterDescription& contents)
{
  const Georeference& location = contents.Location;
  if (location.System != Georeference::Kind::Geographic)
  {
    return "";
  }
  const double sample = std::max(
    std::abs(location.AlongU[1]) / contents.Width, std::abs(location.AlongV[1]) / contents.Height);
  const double largest = 90.0 + std::max(1.0, sample * location.Unit);
  for (int corner = 0; corner < 4; ++corner)
  {
    const double latitude = location.Coordinates(corner % 2, corner / 2)[1] * location.Unit;
    if (!(std::abs(latitude) <= largest))
    {
      return "it has latitudes beyond the poles, so its coordinate system does not fit its "
             "coordinates; give it the right one (gdal_translate -a_srs)";
    }
  }
  return "";
}

// glibc keeps the memory that threads have freed, which is much after an index is built.
void ReleaseFreeMemory()
{
#if defined(__GLIBC__)
  malloc_trim(0);
#endif
}

bool IsFile(const std::string& name)
{
  std::error_code failure;
  return fs::is_regular_file(fs::u8path(name), failure);
}
}

RasterPyramid::RasterPyramid() = default;

RasterPyramid::~RasterPyramid() = default;

std::shared_ptr<RasterPyramid> RasterPyramid::Open(const std::string& fileName,
  const std::string& cacheFolder, std::string& error, std::int64_t indexMemoryLimit)
{
  std::shared_ptr<RasterPyramid> pyramid(new RasterPyramid);
  pyramid->FileName = fileName;
  pyramid->File = PyramidFile::Open(fileName, error);
  if (!pyramid->File)
  {
    return nullptr;
  }
  error = FindLatitudeError(pyramid->File->Describe());
  if (!error.empty())
  {
    return nullptr;
  }
  pyramid->Signature = pyramid->File->GetSignature();
  pyramid->MakeEstimates();
  StartIndex(pyramid, cacheFolder, indexMemoryLimit);
  // The users share this pointer; the thread has another one.
  return { pyramid.get(), [pyramid](RasterPyramid*) { pyramid->StopIndex(); } };
}

std::array<int, 2> RasterPyramid::GetNumberOfTiles(int level) const
{
  const std::array<int, 2>& size = this->File->GetSize(level);
  constexpr int tile = PyramidIndex::TileSize;
  return { { (size[0] + tile - 1) / tile, (size[1] + tile - 1) / tile } };
}

TileCache::TilePointer RasterPyramid::GetTile(int level, int column, int row, std::string& error)
{
  return this->Cache.Get(level, column, row,
    [&]() -> TileCache::TilePointer
    {
      constexpr int size = PyramidIndex::TileSize;
      auto tile = std::make_shared<PyramidTile>();
      SampleWindow& window = tile->Window;
      window.Level = level;
      window.Column = column * size;
      window.Row = row * size;
      window.Width = std::min(size, this->File->GetSize(level)[0] - window.Column);
      window.Height = std::min(size, this->File->GetSize(level)[1] - window.Row);
      bool isRead = false;
      if (this->File->HasFloatSamples())
      {
        tile->Floats.resize(window.GetNumberOfSamples());
        isRead = this->File->Read(window, tile->Floats.data(), error);
      }
      else
      {
        tile->Doubles.resize(window.GetNumberOfSamples());
        isRead = this->File->Read(window, tile->Doubles.data(), error);
      }
      return isRead ? tile : nullptr;
    });
}

bool RasterPyramid::Interpolate(double column, double row, double& value, std::string& error)
{
  const std::array<int, 2>& size = this->File->GetSize(0);
  const auto snap = [](double position, int number)
  {
    const double nearest = std::round(position);
    return std::clamp(
      std::abs(position - nearest) < SnapDistance ? nearest : position, 0.0, number - 1.0);
  };
  const double x = snap(column, size[0]);
  const double y = snap(row, size[1]);
  const int first[2] = { static_cast<int>(x), static_cast<int>(y) };
  const double weights[2] = { x - first[0], y - first[1] };
  value = 0.0;
  for (int corner = 0; corner < 4; ++corner)
  {
    const int i = corner % 2;
    const int j = corner / 2;
    const double weight =
      (i == 1 ? weights[0] : 1.0 - weights[0]) * (j == 1 ? weights[1] : 1.0 - weights[1]);
    if (weight == 0.0)
    {
      continue; // the sample may lack data, or lie outside
    }
    constexpr int tileSize = PyramidIndex::TileSize;
    const int c = first[0] + i;
    const int r = first[1] + j;
    const TileCache::TilePointer tile = this->GetTile(0, c / tileSize, r / tileSize, error);
    if (!tile)
    {
      value = std::numeric_limits<double>::quiet_NaN();
      return false;
    }
    value += weight * tile->GetSample(c, r);
  }
  return true;
}

void RasterPyramid::MakeEstimates()
{
  this->EstimatedRange = EstimateRange(*this->File);
  const std::array<int, 2>& size = this->File->GetSize(0);
  // On slopes of 45 degrees, rough terrain differs from a triangle by about a quarter of its size.
  const double error = 0.25 * GetSampleDistance(this->File->Describe());
  this->Errors = std::make_shared<const BlockErrors>(
    BlockErrors::Estimate(BlockErrors::GetRootLevel(size[0], size[1]), static_cast<float>(error)));
  this->Ranges = std::make_shared<const ElevationRanges>(ElevationRanges::Range{
    { static_cast<float>(this->EstimatedRange[0]), static_cast<float>(this->EstimatedRange[1]) } });
}

std::shared_ptr<const BlockErrors> RasterPyramid::GetBlockErrors() const
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  return this->Errors;
}

std::shared_ptr<const ElevationRanges> RasterPyramid::GetElevationRanges() const
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  return this->Ranges;
}

void RasterPyramid::StartIndex(const std::shared_ptr<RasterPyramid>& pyramid,
  const std::string& cacheFolder, std::int64_t memoryLimit)
{
  if (pyramid->ReadIndex(cacheFolder))
  {
    pyramid->UseIndex();
    pyramid->HasEnded = true;
    return;
  }
  pyramid->Index = PyramidIndex(pyramid->File->GetSizes());
  pyramid->Builder = std::make_unique<PyramidIndexBuilder>(*pyramid->File, pyramid->Abort);
  pyramid->Builder->SetMemoryLimit(memoryLimit);
  try
  {
    pyramid->Thread = std::thread([pyramid]() { pyramid->BuildIndex(); });
  }
  catch (const std::system_error& error)
  {
    pyramid->Error = std::string("no thread can be started to index it: ") + error.what();
    pyramid->HasEnded = true;
  }
}

bool RasterPyramid::ReadIndex(const std::string& cacheFolder)
{
  this->Index = PyramidIndex(this->File->GetSizes());
  const std::string folder = cacheFolder.empty() ? FindCacheFolder() : cacheFolder;
  if (cacheFolder.empty() && FindContainer(this->FileName) == this->FileName &&
    IsFile(this->FileName))
  {
    this->IndexFileNames[0] = this->FileName + PyramidIndex::FileExtension;
  }
  if (!folder.empty())
  {
    this->IndexFileNames[1] = MakeCacheFileName(folder, this->FileName);
  }
  for (const std::string& name : this->IndexFileNames)
  {
    if (!name.empty() && this->Index.Read(name, this->Signature))
    {
      return true;
    }
  }
  return false;
}

void RasterPyramid::StopIndex()
{
  this->Abort = true;
  if (!this->Thread.joinable())
  {
    return;
  }
  std::unique_lock<std::mutex> lock(this->Mutex);
  if (this->Ended.wait_for(lock, LongestWait, [this] { return this->HasEnded; }))
  {
    lock.unlock();
    this->Thread.join();
  }
  else
  {
    this->Thread.detach();
  }
}

// Replaces the estimates.
void RasterPyramid::UseIndex()
{
  const RasterDescription& contents = this->File->Describe();
  auto ranges = std::make_shared<const ElevationRanges>(
    this->Index.MakeElevationRanges(contents.Scale, contents.Offset));
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Errors = this->Index.GetBlockErrors();
    this->Ranges = std::move(ranges);
  }
  this->IsComplete = true;
}

void RasterPyramid::BuildIndex()
{
  std::string error;
  const int threads = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  bool isBuilt = false;
  try
  {
    isBuilt = this->Builder->Build(threads, this->Index, error);
  }
  catch (const std::bad_alloc&) // an exception that leaves a thread ends the program
  {
    error = "there is not enough memory to index the raster";
  }
  this->File->CloseIdleHandles();
  ReleaseFreeMemory();
  if (isBuilt && this->File->HasChanged())
  {
    isBuilt = false;
    error = "the file has changed while it was indexed; open it again";
  }
  if (isBuilt)
  {
    this->UseIndex();
  }
  if (isBuilt && error.empty()) // samples that cannot be read now may be readable later
  {
    for (const std::string& name : this->IndexFileNames)
    {
      std::error_code failure;
      if (!name.empty())
      {
        fs::create_directories(fs::u8path(name).parent_path(), failure);
        if (this->Index.Write(name, this->Signature).empty())
        {
          break;
        }
      }
    }
  }
  const std::lock_guard<std::mutex> lock(this->Mutex);
  this->Error = error;
  this->HasEnded = true;
  this->Ended.notify_all();
}

double RasterPyramid::GetProgress() const
{
  return this->IsComplete || !this->Builder ? 1.0 : this->Builder->GetProgress();
}

bool RasterPyramid::HasIndexEnded() const
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  return this->HasEnded;
}

std::string RasterPyramid::GetIndexError() const
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  return this->HasEnded ? this->Error : "";
}
}
