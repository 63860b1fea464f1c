// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Pyramid/PyramidFile.h"

#include "Geodesy/GDALSession.h"
#include "Raster/GDALRaster.h"
#include "Raster/RasterFile.h"
#include "Raster/RawFile.h"
#include "Raster/RawSamples.h"
#include "Raster/StoredNoData.h"
#include "vtkType.h"

#include <cpl_vsi.h>
#include <gdal.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <sstream>
#include <type_traits>
#include <utility>

namespace relevo
{
namespace
{
// The blocks that are cached for each thread that reads have at most this many bytes. Those that
// GDAL caches in each handle do, too, or are the blocks of one window; no limit of ours counts
// them.
constexpr double MaximumCachedBytes = 2.0 * 1024 * 1024;

// The largest windows whose blocks threads share.
constexpr int MaximumSharedBlocks = 64;
constexpr double MaximumSharedBytes = 4.0 * 1024 * 1024;

// GDAL's TIFF driver stores the position and size of each block of the file in each handle, in
// arrays that grow. For large files, fewer handles limit this memory.
constexpr double BytesPerPosition = 24.0;
constexpr double MaximumPositionBytes = 32.0 * 1024 * 1024;
constexpr double MostHandles = 64.0;

// Columns and rows of blocks are below 2^28.
constexpr int BlockRowShift = 28;
constexpr int BlockLevelShift = 56;

std::uint64_t MakeBlockKey(int level, int column, int row)
{
  return static_cast<std::uint64_t>(level) << BlockLevelShift |
    static_cast<std::uint64_t>(row) << BlockRowShift | static_cast<std::uint64_t>(column);
}

std::array<int, 2> GetBlockOfKey(std::uint64_t key)
{
  constexpr std::uint64_t mask = (std::uint64_t(1) << BlockRowShift) - 1;
  return { { static_cast<int>(key & mask), static_cast<int>(key >> BlockRowShift & mask) } };
}

template <typename T>
constexpr GDALDataType GetSampleType()
{
  return std::is_same<T, float>::value ? GDT_Float32 : GDT_Float64;
}

constexpr char Changed[] = "the file has changed since it was opened; open it again";

bool FitsIntoFloat(int type)
{
  return type == VTK_UNSIGNED_CHAR || type == VTK_SIGNED_CHAR || type == VTK_SHORT ||
    type == VTK_UNSIGNED_SHORT || type == VTK_FLOAT;
}

// Columns or rows of blocks.
struct BlockRange
{
  int First = 0;
  int End = 0;

  BlockRange() = default;
  BlockRange(int firstSample, int samples, int samplesPerBlock)
    : First(firstSample / samplesPerBlock)
    , End((firstSample + samples - 1) / samplesPerBlock + 1)
  {
  }
  int GetSize() const { return this->End - this->First; }
  int CountCommon(const BlockRange& other) const
  {
    return std::max(0, std::min(this->End, other.End) - std::max(this->First, other.First));
  }
};
}

struct PyramidFile::Handle
{
  GDALDatasetPointer Dataset;
  std::vector<GDALRasterBandH> Bands;                // by level
  std::vector<GDALRasterBandH> Masks;                // of the bands, for files that have masks
  std::unique_ptr<RawSamples> Raw;                   // of level 0; null for most files
  std::vector<std::array<BlockRange, 2>> LastBlocks; // of the last window of each level
  double CachedBytes = 0.0;

  // Drops cached blocks if the new ones of a window exceed the limit.
  void MakeRoom(const SampleWindow& window)
  {
    const GDALRasterBandH band = this->Bands[window.Level];
    int width = 1;
    int height = 1;
    GDALGetBlockSize(band, &width, &height);
    const std::array<BlockRange, 2> blocks = { { BlockRange(window.Column, window.Width, width),
      BlockRange(window.Row, window.Height, height) } };
    std::array<BlockRange, 2>& last = this->LastBlocks[window.Level];
    const double bytesPerBlock = static_cast<double>(width) * height *
      (GDALGetDataTypeSizeBits(GDALGetRasterDataType(band)) / 8.0);
    const double all = bytesPerBlock * blocks[0].GetSize() * blocks[1].GetSize();
    const double added =
      all - bytesPerBlock * blocks[0].CountCommon(last[0]) * blocks[1].CountCommon(last[1]);
    if (added > 0.0 && this->CachedBytes + added > MaximumCachedBytes)
    {
      this->DropBlocks();
      this->CachedBytes = all;
    }
    else
    {
      this->CachedBytes += added;
    }
    last = blocks;
  }

  // GDALFlushCache() would leave the blocks of overviews.
  void DropBlocks()
  {
    for (const std::vector<GDALRasterBandH>* bands : { &this->Bands, &this->Masks })
    {
      for (const GDALRasterBandH band : *bands)
      {
        GDALFlushRasterCache(band);
      }
    }
    std::fill(this->LastBlocks.begin(), this->LastBlocks.end(), std::array<BlockRange, 2>());
  }
};

// A handle for as long as a thread reads.
class PyramidFile::Lease
{
public:
  // Waits while all handles are in use.
  Lease(const PyramidFile& file, std::string& error)
    : File(file)
  {
    {
      std::unique_lock<std::mutex> lock(file.Mutex);
      file.Returned.wait(lock, [&file] { return file.HandlesInUse < file.MaximumHandles; });
      ++file.HandlesInUse;
      if (file.HandlesInUse > file.LargestHandlesInUse)
      {
        file.LargestHandlesInUse = file.HandlesInUse;
        file.Blocks.SetLimit(static_cast<std::size_t>(file.HandlesInUse * MaximumCachedBytes));
      }
      if (!file.Free.empty())
      {
        this->Owned = std::move(file.Free.back());
        file.Free.pop_back();
      }
    }
    try
    {
      if (!this->Owned)
      {
        this->Owned = file.NewHandle(error);
      }
    }
    catch (...)
    {
      this->Return();
      throw;
    }
  }
  ~Lease() { this->Return(); }
  Lease(const Lease&) = delete;
  void operator=(const Lease&) = delete;

  Handle* Get() const { return this->Owned.get(); }

  /// Close the dataset, so that the next lease opens a new one.
  void Close() { this->Owned.reset(); }

private:
  void Return()
  {
    {
      const std::lock_guard<std::mutex> lock(this->File.Mutex);
      --this->File.HandlesInUse;
      if (this->Owned)
      {
        this->File.Free.push_back(std::move(this->Owned));
      }
    }
    this->File.Returned.notify_one();
  }

  const PyramidFile& File;
  std::unique_ptr<Handle> Owned;
};

PyramidFile::PyramidFile() = default;

PyramidFile::~PyramidFile()
{
  GDALSession session; // collects what GDAL reports while it closes the file
  this->Free.clear();
}

std::unique_ptr<PyramidFile> PyramidFile::Open(const std::string& fileName, std::string& error)
{
  error = FindRasterFileError(fileName);
  if (!error.empty())
  {
    return nullptr;
  }
  std::unique_ptr<PyramidFile> file(new PyramidFile);
  file->FileName = fileName;
  GDALSession::ForgetFile(fileName); // a server may have failed before
  const FileVersion before(fileName);
  GDALSession session;
  auto handle = std::make_unique<Handle>();
  handle->Dataset = file->OpenDataset(session, error);
  const GDALDatasetH dataset = handle->Dataset.get();
  if (!dataset || !GDALRaster::Describe(dataset, file->Description, error))
  {
    return nullptr;
  }
  error = FindTruncation(dataset);
  if (!error.empty())
  {
    return nullptr;
  }
  file->IsFloat = FitsIntoFloat(file->Description.Type);
  file->FindLevels(dataset);
  file->IsRaw = !file->Description.HasMask && RawSamples::Open(dataset);
  file->Version = FileVersion(fileName, dataset);
  if (!file->SetBands(*handle, error))
  {
    return nullptr;
  }
  if (before.HasChanged())
  {
    error = "the file has changed while it was opened";
    return nullptr;
  }
  // On slow disks, opening takes seconds: the first reader uses this dataset.
  file->Free.push_back(std::move(handle));
  return file;
}

GDALDatasetPointer PyramidFile::OpenDataset(const GDALSession& session, std::string& error) const
{
  GDALDatasetPointer dataset(GDALOpenEx(this->FileName.c_str(),
    GDAL_OF_RASTER | GDAL_OF_READONLY | GDAL_OF_VERBOSE_ERROR, nullptr, nullptr, nullptr));
  if (!dataset)
  {
    error = session.Messages("GDAL does not recognise it as a raster");
    GDALSession::ForgetFile(this->FileName);
  }
  return dataset;
}

void PyramidFile::FindLevels(GDALDatasetH dataset)
{
  const GDALRasterBandH band = GDALGetRasterBand(dataset, 1);
  int blockWidth = 1;
  int blockHeight = 1;
  GDALGetBlockSize(band, &blockWidth, &blockHeight);
  this->StoredType = GDALGetRasterDataType(band);
  this->IsStoredInRows = blockWidth >= GDALGetRasterBandXSize(band) && blockWidth > blockHeight;
  const auto countBlocks = [blockWidth, blockHeight](GDALRasterBandH one)
  {
    return std::ceil(static_cast<double>(GDALGetRasterBandXSize(one)) / blockWidth) *
      std::ceil(static_cast<double>(GDALGetRasterBandYSize(one)) / blockHeight);
  };
  double blocks = countBlocks(band);
  std::vector<std::pair<std::array<int, 2>, int>> levels = {
    { { { GDALGetRasterBandXSize(band), GDALGetRasterBandYSize(band) } }, -1 }
  };
  for (int i = 0; i < GDALGetOverviewCount(band); ++i)
  {
    const GDALRasterBandH overview = GDALGetOverview(band, i);
    if (overview && GDALGetRasterDataType(overview) == GDALGetRasterDataType(band))
    {
      blocks += countBlocks(overview);
      levels.push_back(
        { { { GDALGetRasterBandXSize(overview), GDALGetRasterBandYSize(overview) } }, i });
    }
  }
  std::stable_sort(levels.begin() + 1, levels.end(),
    [](const auto& a, const auto& b) { return a.first > b.first; });
  for (const auto& [size, number] : levels)
  {
    const bool isFirst = this->Sizes.empty();
    const bool isSmaller = !isFirst && size[0] <= this->Sizes.back()[0] &&
      size[1] <= this->Sizes.back()[1] && size != this->Sizes.back();
    if (isFirst || (isSmaller && size[0] > 0 && size[1] > 0))
    {
      this->Sizes.push_back(size);
      this->Overviews.push_back(number);
      this->BlockSizes.emplace_back();
      GDALGetBlockSize(number < 0 ? band : GDALGetOverview(band, number),
        &this->BlockSizes.back()[0], &this->BlockSizes.back()[1]);
    }
  }
  this->BytesOfPositions = BytesPerPosition * blocks;
  this->MaximumHandles =
    static_cast<int>(std::clamp(MaximumPositionBytes / this->BytesOfPositions, 1.0, MostHandles));
}

bool PyramidFile::SetBands(Handle& handle, std::string& error) const
{
  const GDALRasterBandH band = GDALGetRasterBand(handle.Dataset.get(), 1);
  for (std::size_t level = 0; level < this->Sizes.size(); ++level)
  {
    const int number = this->Overviews[level];
    const GDALRasterBandH found = number < 0 ? band : GDALGetOverview(band, number);
    if (!found || GDALGetRasterBandXSize(found) != this->Sizes[level][0] ||
      GDALGetRasterBandYSize(found) != this->Sizes[level][1])
    {
      error = Changed;
      return false;
    }
    handle.Bands.push_back(found);
    if (this->Description.HasMask)
    {
      handle.Masks.push_back(GDALGetMaskBand(found));
    }
  }
  handle.LastBlocks.resize(handle.Bands.size());
  handle.Raw = this->IsRaw ? RawSamples::Open(handle.Dataset.get()) : nullptr;
  return true;
}

std::unique_ptr<PyramidFile::Handle> PyramidFile::NewHandle(std::string& error) const
{
  GDALSession session;
  auto handle = std::make_unique<Handle>();
  handle->Dataset = this->OpenDataset(session, error);
  if (!handle->Dataset || !this->SetBands(*handle, error))
  {
    error = this->HasChanged() ? Changed : error;
    return nullptr;
  }
  return handle;
}

// Blocks of rows are wider than windows, and masks decide about the samples of some files.
bool PyramidFile::AreBlocksShared(const SampleWindow& window) const
{
  const std::array<int, 2>& size = this->BlockSizes[window.Level];
  const int number = BlockRange(window.Column, window.Width, size[0]).GetSize() *
    BlockRange(window.Row, window.Height, size[1]).GetSize();
  return !this->IsStoredInRows && !this->Description.HasMask && number <= MaximumSharedBlocks &&
    static_cast<double>(number) * size[0] * size[1] * GDALGetDataTypeSizeBytes(this->StoredType) <=
    MaximumSharedBytes;
}

std::string PyramidFile::DescribeFailure(
  const SampleWindow& window, const GDALSession& session, Lease& lease) const
{
  std::ostringstream place;
  place << "GDAL cannot read the " << window.Width << " x " << window.Height
        << " samples from column " << window.Column << ", row " << window.Row << " of level "
        << window.Level;
  const std::string error = this->HasChanged() ? Changed : session.Messages(place.str());
  if (this->IsVirtual())
  {
    lease.Close();
    GDALSession::ForgetFile(this->FileName);
  }
  return error;
}

// Copies the samples of a window from the blocks of the file.
template <typename T>
class PyramidFile::WindowReader : public BlockCache::Reader
{
public:
  WindowReader(const PyramidFile& file, const SampleWindow& window, T* samples, std::string& error)
    : File(file)
    , Window(window)
    , Samples(samples)
    , Error(error)
    , Size(file.BlockSizes[window.Level])
    , BytesPerSample(GDALGetDataTypeSizeBytes(file.StoredType))
  {
  }

  std::vector<std::uint64_t> GetBlocks() const
  {
    const BlockRange columns(this->Window.Column, this->Window.Width, this->Size[0]);
    const BlockRange rows(this->Window.Row, this->Window.Height, this->Size[1]);
    std::vector<std::uint64_t> keys;
    for (int row = rows.First; row < rows.End; ++row)
    {
      for (int column = columns.First; column < columns.End; ++column)
      {
        keys.push_back(MakeBlockKey(this->Window.Level, column, row));
      }
    }
    return keys;
  }

  bool Prepare() override
  {
    this->Lent.emplace(this->File, this->Error);
    return this->Lent->Get() != nullptr;
  }

  BlockCache::BlockPointer Load(std::uint64_t key) override
  {
    GDALSession session;
    const std::array<int, 2> at = GetBlockOfKey(key);
    auto block = std::make_shared<BlockCache::Block>(
      static_cast<std::size_t>(this->Size[0]) * this->Size[1] * this->BytesPerSample);
    const GDALRasterBandH band = this->Lent->Get()->Bands[this->Window.Level];
    if (GDALReadBlock(band, at[0], at[1], block->Bytes.get()) != CE_None || session.HasErrors())
    {
      this->Error = this->File.DescribeFailure(this->Window, session, *this->Lent);
      return nullptr;
    }
    return block;
  }

  void Use(std::uint64_t key, const BlockCache::Block& block) override
  {
    const SampleWindow& window = this->Window;
    const std::array<int, 2> at = GetBlockOfKey(key);
    const int first[2] = { at[0] * this->Size[0], at[1] * this->Size[1] };
    const int begin = std::max(first[0], window.Column);
    const int end = std::min(first[0] + this->Size[0], window.Column + window.Width);
    const int endRow = std::min(first[1] + this->Size[1], window.Row + window.Height);
    for (int row = std::max(first[1], window.Row); row < endRow; ++row)
    {
      const std::size_t from =
        static_cast<std::size_t>(row - first[1]) * this->Size[0] + (begin - first[0]);
      const std::size_t to =
        static_cast<std::size_t>(row - window.Row) * window.Width + (begin - window.Column);
      GDALCopyWords(block.Bytes.get() + from * this->BytesPerSample, this->File.StoredType,
        this->BytesPerSample, this->Samples + to, GetSampleType<T>(), sizeof(T), end - begin);
    }
  }

private:
  const PyramidFile& File;
  const SampleWindow& Window;
  T* Samples;
  std::string& Error;
  const std::array<int, 2>& Size; // of a block
  int BytesPerSample;
  std::optional<Lease> Lent;
};

template <typename T>
bool PyramidFile::ReadWindow(const SampleWindow& window, T* samples,
  std::vector<unsigned char>& mask, std::string& error) const
{
  Lease lease(*this, error);
  Handle* handle = lease.Get();
  if (!handle)
  {
    return false;
  }
  GDALSession session;
  if (handle->Raw && window.Level == 0)
  {
    if (!handle->Raw->Read(window.Column, window.Row, window.Width, window.Height,
          GetSampleType<T>(), reinterpret_cast<unsigned char*>(samples)))
    {
      error = this->DescribeFailure(window, session, lease);
      return false;
    }
    return true;
  }
  handle->MakeRoom(window);
  const CPLErr result =
    GDALRasterIO(handle->Bands[window.Level], GF_Read, window.Column, window.Row, window.Width,
      window.Height, samples, window.Width, window.Height, GetSampleType<T>(), 0, 0);
  mask.resize(this->Description.HasMask ? window.GetNumberOfSamples() : 0);
  const bool hasMask = mask.empty() ||
    GDALRasterIO(handle->Masks[window.Level], GF_Read, window.Column, window.Row, window.Width,
      window.Height, mask.data(), window.Width, window.Height, GDT_Byte, 0, 0) == CE_None;
  if (result != CE_None || !hasMask || session.HasErrors())
  {
    error = this->DescribeFailure(window, session, lease);
    return false;
  }
  return true;
}

template <typename T>
bool PyramidFile::ReadAs(const SampleWindow& window, T* samples, std::string& error) const
{
  std::vector<unsigned char> mask;
  bool isRead = false;
  if (this->AreBlocksShared(window))
  {
    WindowReader<T> reader(*this, window, samples, error);
    isRead = this->Blocks.Use(reader.GetBlocks(), reader);
  }
  else
  {
    isRead = this->ReadWindow(window, samples, mask, error);
  }
  if (!isRead)
  {
    return false;
  }
  if (this->HasChanged())
  {
    error = Changed;
    return false;
  }
  constexpr T missing = std::numeric_limits<T>::quiet_NaN();
  const bool hasNoData = this->Description.NoData.has_value();
  // Other types than float store every declared value that can match as a double.
  const double declared = this->Description.NoData.value_or(missing);
  const T noData = static_cast<T>(
    this->Description.Type == VTK_FLOAT ? GetStoredNoData<float>(declared) : declared);
  const std::size_t n = window.GetNumberOfSamples();
  for (std::size_t i = 0; i < n; ++i)
  {
    const bool isMissing = (hasNoData && samples[i] == noData) || (!mask.empty() && mask[i] == 0) ||
      !std::isfinite(samples[i]);
    samples[i] = isMissing ? missing : samples[i];
  }
  return true;
}

std::int64_t PyramidFile::GetMemoryOfReading(int threads) const
{
  const double perHandle = MaximumCachedBytes + this->BytesOfPositions;
  return static_cast<std::int64_t>(std::min(threads, this->MaximumHandles) * perHandle);
}

void PyramidFile::CloseIdleHandles() const
{
  GDALSession session; // collects what GDAL reports while it closes the file
  const std::lock_guard<std::mutex> lock(this->Mutex);
  this->Free.clear();
  this->LargestHandlesInUse = 0;
  this->Blocks.SetLimit(0); // until the next read
}

bool PyramidFile::Read(const SampleWindow& window, double* samples, std::string& error) const
{
  return this->ReadAs(window, samples, error);
}

bool PyramidFile::Read(const SampleWindow& window, float* samples, std::string& error) const
{
  return this->ReadAs(window, samples, error);
}

bool PyramidFile::IsAbsent(const SampleWindow& window) const
{
  if (this->Description.HasMask)
  {
    return false; // the mask decides, and it can be stored where samples are not
  }
  std::string ignored; // the read that follows reports it
  const Lease lease(*this, ignored);
  if (!lease.Get())
  {
    return false;
  }
  GDALSession session;
  const int status = GDALGetDataCoverageStatus(lease.Get()->Bands[window.Level], window.Column,
    window.Row, window.Width, window.Height, GDAL_DATA_COVERAGE_STATUS_DATA, nullptr);
  return (status & (GDAL_DATA_COVERAGE_STATUS_DATA | GDAL_DATA_COVERAGE_STATUS_UNIMPLEMENTED)) == 0;
}

double PyramidFile::GetAbsentSample() const
{
  return this->Description.NoData ? std::numeric_limits<double>::quiet_NaN() : 0.0;
}

std::string PyramidFile::GetSignature() const
{
  std::ostringstream text;
  text.precision(17);
  const RasterDescription& contents = this->Description;
  text << this->Version.DescribeCurrent() << contents.Type << ' ' << contents.NoData.value_or(0.0)
       << ' ' << contents.NoData.has_value() << ' ' << contents.HasMask << ' ' << contents.Scale
       << ' ' << contents.Offset << ' ' << contents.VerticalUnit;
  for (const std::array<int, 2>& size : this->Sizes)
  {
    text << ' ' << size[0] << 'x' << size[1];
  }
  return text.str();
}
}
