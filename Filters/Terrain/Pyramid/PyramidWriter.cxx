// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Pyramid/PyramidWriter.h"

#include "Files/AtomicFile.h"
#include "Pyramid/PyramidFile.h"
#include "Pyramid/PyramidIndex.h"
#include "Pyramid/PyramidIndexBuilder.h"
#include "Raster/RasterFile.h"
#include "Raster/RawFile.h"
#include "Raster/StoredNoData.h"

#include <cpl_conv.h>
#include <cpl_string.h>
#include <cpl_vsi.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <future>
#include <limits>
#include <new>
#include <optional>
#include <sstream>
#include <system_error>
#include <thread>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

namespace relevo
{
namespace
{
namespace fs = std::filesystem;

constexpr int SmallestBlockSize = 256;
// Readers have the position and size of each block in memory. Larger rasters have larger blocks.
constexpr double MaximumBlocks = 1 << 20;
// A window that is copied at once has this many samples, in one or two rows of blocks.
constexpr int SamplesPerWindow = 1 << 22;
constexpr int SmallestWindowHeight = 2 * SmallestBlockSize;
// The journal gets an entry after this many bytes.
constexpr double BytesPerFlush = 256.0 * 1024 * 1024;

// GDAL's options for the time of a call, on this thread.
class ScopedOption
{
public:
  ScopedOption(const char* name, const char* value)
    : Name(name)
  {
    CPLSetThreadLocalConfigOption(name, value);
  }
  ~ScopedOption() { CPLSetThreadLocalConfigOption(this->Name, nullptr); }
  ScopedOption(const ScopedOption&) = delete;
  void operator=(const ScopedOption&) = delete;

private:
  const char* Name;
};

const char* GetPredictor(GDALDataType type, const std::string& compression)
{
  const bool hasPredictor =
    compression == "DEFLATE" || compression == "LZW" || compression == "ZSTD";
  const bool isFloat = type == GDT_Float32 || type == GDT_Float64;
  return !hasPredictor ? "1" : (isFloat ? "3" : "2");
}

int ChooseBlockSize(double width, double height)
{
  int size = SmallestBlockSize;
  while (std::ceil(width / size) * std::ceil(height / size) > MaximumBlocks)
  {
    size *= 2;
  }
  return size;
}

// The size of a level: GDAL's overviews are rounded up.
int GetLevelSize(int size, int level)
{
  for (int i = 0; i < level; ++i)
  {
    size = (size + 1) / 2;
  }
  return size;
}
}

// An advisory lock that ends with the process.
class PyramidWriter::Lock
{
public:
  explicit Lock(const std::string& name)
    : Name(name)
    , Descriptor(open(name.c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0666))
  {
    if (this->Descriptor < 0)
    {
      this->Error = std::strerror(errno);
    }
    else if (flock(this->Descriptor, LOCK_EX | LOCK_NB) != 0)
    {
      this->Error = "another process is writing it";
      close(this->Descriptor);
      this->Descriptor = -1;
    }
  }
  ~Lock()
  {
    if (this->Descriptor >= 0)
    {
      unlink(this->Name.c_str());
      close(this->Descriptor);
    }
  }
  Lock(const Lock&) = delete;
  void operator=(const Lock&) = delete;

  const std::string& GetError() const { return this->Error; }

private:
  std::string Name;
  int Descriptor;
  std::string Error;
};

PyramidWriter::PyramidWriter(const Settings& settings, const Progress& progress)
  : Wanted(settings)
  , Report(progress)
{
  // The file that a symbolic link leads to is replaced, not the link.
  std::error_code failure;
  fs::path path = fs::u8path(settings.Output);
  path = fs::is_symlink(path, failure) ? fs::weakly_canonical(path, failure) : path;
  this->TargetName = path.u8string();
  const std::string hidden = (path.parent_path() / ("." + path.filename().u8string())).u8string();
  this->PartialName = hidden + ".relevo-part.tif";
  this->JournalName = hidden + ".relevo-journal";
  this->LockName = hidden + ".relevo-lock";
}

PyramidWriter::~PyramidWriter()
{
  GDALSession session; // collects what GDAL reports while it closes the files
  this->Target.reset();
  this->Source.reset();
}

PyramidWriter::Result PyramidWriter::Write(std::string& error)
{
  std::error_code failure;
  const fs::path output = fs::u8path(this->Wanted.Output);
  if (fs::exists(output, failure) && !fs::is_regular_file(output, failure))
  {
    error = "Cannot write " + this->Wanted.Output + ": it is not a regular file";
    return Result::Failed;
  }
  error = AtomicFile::FindError(this->Wanted.Output);
  if (!error.empty())
  {
    error = "Cannot write " + this->Wanted.Output + ": " + error;
    return Result::Failed;
  }
  if (fs::equivalent(
        fs::u8path(FindContainer(this->Wanted.Input)), fs::u8path(this->Wanted.Output), failure))
  {
    error = "Cannot write " + this->Wanted.Output + ": it is the input";
    return Result::Failed;
  }
  if (!this->OpenInput(error))
  {
    error = "Cannot read " + this->Wanted.Input + ": " + error;
    return Result::Failed;
  }
  const Lock lock(this->LockName);
  error = lock.GetError();
  Result result = Result::Failed;
  if (error.empty())
  {
    this->RemoveTemporaries();
  }
  if (error.empty() && (this->Resume() || this->Create(error)))
  {
    result = this->CopyLevels(error);
  }
  result = result == Result::Done ? this->CloseTarget(error) : result;
  result = result == Result::Done && this->Wanted.HasIndex ? this->WriteIndex(error) : result;
  result = result == Result::Done ? this->Publish(error) : result;
  if (result == Result::Failed)
  {
    error = "Cannot write " + this->Wanted.Output + ": " + error;
  }
  return result;
}

bool PyramidWriter::OpenInput(std::string& error)
{
  error = FindRasterFileError(this->Wanted.Input);
  if (!error.empty())
  {
    return false;
  }
  GDALSession session;
  this->Source.reset(GDALOpenEx(this->Wanted.Input.c_str(),
    GDAL_OF_RASTER | GDAL_OF_READONLY | GDAL_OF_VERBOSE_ERROR, nullptr, nullptr, nullptr));
  if (!this->Source || GDALGetRasterCount(this->Source.get()) < 1)
  {
    error = session.Messages("GDAL finds no raster in it");
    return false;
  }
  error = FindTruncation(this->Source.get());
  const GDALRasterBandH band = GDALGetRasterBand(this->Source.get(), 1);
  this->Type = GDALGetRasterDataType(band);
  this->Width = GDALGetRasterBandXSize(band);
  this->Height = GDALGetRasterBandYSize(band);
  if (GDALDataTypeIsComplex(this->Type))
  {
    error = "its samples are complex numbers";
  }
  else if ((GDALGetMaskFlags(band) & (GMF_PER_DATASET | GMF_ALPHA)) != 0)
  {
    error = "missing samples are declared by a mask; give them a no-data value first, for example "
            "with gdalwarp -dstnodata";
  }
  this->BlockSize = ChooseBlockSize(this->Width, this->Height);
  while (std::max(GetLevelSize(this->Width, this->NumberOfLevels - 1),
           GetLevelSize(this->Height, this->NumberOfLevels - 1)) > SmallestBlockSize)
  {
    ++this->NumberOfLevels;
  }
  for (int level = 0; level < this->NumberOfLevels; ++level)
  {
    this->AllSamples +=
      static_cast<double>(GetLevelSize(this->Width, level)) * GetLevelSize(this->Height, level);
  }
  return error.empty();
}

// A killed run can leave a temporary file of the journal.
void PyramidWriter::RemoveTemporaries() const
{
  const fs::path journal = fs::u8path(this->JournalName);
  const std::string first = "." + journal.stem().u8string() + ".";
  std::error_code failure;
  const fs::path folder = journal.has_parent_path() ? journal.parent_path() : fs::path(".");
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, failure))
  {
    const std::string name = entry.path().filename().u8string();
    if (name.compare(0, first.size(), first) == 0 && AtomicFile::IsTemporary(name) &&
      entry.path().extension() == journal.extension())
    {
      fs::remove(entry.path(), failure);
    }
  }
}

std::string PyramidWriter::MakeJournalHeader() const
{
  std::ostringstream text;
  text << "relevo pyramid journal 2\n" << this->Wanted.Input << '\n' << this->Wanted.Compression;
  VSIStatBufL status;
  if (VSIStatL(FindContainer(this->Wanted.Input).c_str(), &status) == 0)
  {
    text << ' ' << status.st_size << ' ' << status.st_mtime;
  }
  text << ' ' << this->Width << ' ' << this->Height << ' ' << this->Type << '\n';
  return text.str();
}

bool PyramidWriter::Resume()
{
  std::ifstream stream(fs::u8path(this->JournalName));
  std::ostringstream contents;
  contents << stream.rdbuf();
  const std::string text = contents.str();
  const std::string header = this->MakeJournalHeader();
  std::error_code failure;
  std::istringstream position(text.substr(std::min(text.size(), header.size())));
  int level = 0;
  int row = 0;
  if (text.compare(0, header.size(), header) != 0 || !(position >> level >> row) || level < 0 ||
    level > this->NumberOfLevels || !fs::exists(fs::u8path(this->PartialName), failure))
  {
    return false;
  }
  GDALSession session;
  const char* const options[] = { "NUM_THREADS=ALL_CPUS", nullptr };
  this->Target.reset(GDALOpenEx(this->PartialName.c_str(), GDAL_OF_RASTER | GDAL_OF_UPDATE, nullptr,
    const_cast<char**>(options), nullptr));
  if (!this->Target || GDALGetRasterXSize(this->Target.get()) != this->Width ||
    GDALGetRasterYSize(this->Target.get()) != this->Height ||
    GDALGetOverviewCount(GDALGetRasterBand(this->Target.get(), 1)) != this->NumberOfLevels - 1)
  {
    this->Target.reset();
    return false;
  }
  this->Level = level;
  this->Row = row;
  for (int i = 0; i < level && i < this->NumberOfLevels; ++i)
  {
    this->DoneSamples +=
      static_cast<double>(GetLevelSize(this->Width, i)) * GetLevelSize(this->Height, i);
  }
  this->DoneSamples += static_cast<double>(row) * GetLevelSize(this->Width, level);
  return true;
}

bool PyramidWriter::Create(std::string& error)
{
  GDALSession session;
  std::error_code failure;
  fs::remove(fs::u8path(this->JournalName), failure);
  fs::remove(fs::u8path(this->PartialName), failure);
  const std::string compression = "COMPRESS=" + this->Wanted.Compression;
  const std::string predictor =
    std::string("PREDICTOR=") + GetPredictor(this->Type, this->Wanted.Compression);
  const std::string width = "BLOCKXSIZE=" + std::to_string(this->BlockSize);
  const std::string height = "BLOCKYSIZE=" + std::to_string(this->BlockSize);
  const char* const options[] = { "TILED=YES", width.c_str(), height.c_str(), "BIGTIFF=YES",
    "SPARSE_OK=TRUE", "NUM_THREADS=ALL_CPUS", compression.c_str(), predictor.c_str(), nullptr };
  this->Target.reset(GDALCreate(GDALGetDriverByName("GTiff"), this->PartialName.c_str(),
    this->Width, this->Height, 1, this->Type, const_cast<char**>(options)));
  if (!this->Target)
  {
    error = session.Messages("GDAL cannot create the file");
    return false;
  }
  const GDALDatasetH source = this->Source.get();
  const GDALDatasetH target = this->Target.get();
  double transform[6];
  if (GDALGetGeoTransform(source, transform) == CE_None)
  {
    GDALSetGeoTransform(target, transform);
  }
  if (const OGRSpatialReferenceH system = GDALGetSpatialRef(source))
  {
    GDALSetSpatialRef(target, system);
  }
  if (const char* meaning = GDALGetMetadataItem(source, "AREA_OR_POINT", nullptr))
  {
    GDALSetMetadataItem(target, "AREA_OR_POINT", meaning, nullptr);
  }
  const GDALRasterBandH from = GDALGetRasterBand(source, 1);
  const GDALRasterBandH to = GDALGetRasterBand(target, 1);
  int isDeclared = 0;
  const double noData = GDALGetRasterNoDataValue(from, &isDeclared);
  if (isDeclared)
  {
    GDALSetRasterNoDataValue(to, noData);
  }
  const double scale = GDALGetRasterScale(from, nullptr);
  const double offset = GDALGetRasterOffset(from, nullptr);
  if (scale != 1.0 || offset != 0.0)
  {
    GDALSetRasterScale(to, scale);
    GDALSetRasterOffset(to, offset);
  }
  const char* unit = GDALGetRasterUnitType(from);
  if (unit && unit[0] != '\0')
  {
    GDALSetRasterUnitType(to, unit);
  }
  GDALSetDescription(to, GDALGetDescription(from));
  if (session.HasErrors())
  {
    error = session.Messages("");
    return false;
  }
  return this->CreateOverviews(error) && this->Flush(0, 0, error);
}

// Empty ones: the levels are computed afterwards, from what is stored.
bool PyramidWriter::CreateOverviews(std::string& error)
{
  GDALSession session;
  const ScopedOption compression("COMPRESS_OVERVIEW", this->Wanted.Compression.c_str());
  const ScopedOption predictor(
    "PREDICTOR_OVERVIEW", GetPredictor(this->Type, this->Wanted.Compression));
  const ScopedOption sparse("SPARSE_OK_OVERVIEW", "ON");
  const std::string size = std::to_string(this->BlockSize);
  const ScopedOption block("GDAL_TIFF_OVR_BLOCKSIZE", size.c_str());
  std::vector<int> factors;
  for (int level = 1; level < this->NumberOfLevels; ++level)
  {
    factors.push_back(1 << level);
  }
  if (!factors.empty() &&
    GDALBuildOverviews(this->Target.get(), "NONE", static_cast<int>(factors.size()), factors.data(),
      0, nullptr, nullptr, nullptr) != CE_None)
  {
    error = session.Messages("GDAL cannot create overviews");
    return false;
  }
  return true;
}

GDALRasterBandH PyramidWriter::GetBand(int level) const
{
  const GDALRasterBandH band = GDALGetRasterBand(this->Target.get(), 1);
  return level == 0 ? band : GDALGetOverview(band, level - 1);
}

bool PyramidWriter::IsAbsent(GDALRasterBandH band, const SampleWindow& window) const
{
  const int status = GDALGetDataCoverageStatus(band, window.Column, window.Row, window.Width,
    window.Height, GDAL_DATA_COVERAGE_STATUS_DATA, nullptr);
  return (status & (GDAL_DATA_COVERAGE_STATUS_DATA | GDAL_DATA_COVERAGE_STATUS_UNIMPLEMENTED)) == 0;
}

PyramidWriter::Result PyramidWriter::CopyLevels(std::string& error)
{
  for (; this->Level < this->NumberOfLevels; ++this->Level, this->Row = 0)
  {
    const Result result = this->CopyLevel(this->Level, error);
    if (result != Result::Done)
    {
      return result;
    }
  }
  return Result::Done;
}

PyramidWriter::Result PyramidWriter::CopyLevel(int level, std::string& error)
{
  const int width = GetLevelSize(this->Width, level);
  const int height = GetLevelSize(this->Height, level);
  const int windowHeight = std::max(SmallestWindowHeight, this->BlockSize);
  const int windowWidth = SamplesPerWindow / windowHeight;
  double unflushed = 0.0;
  for (; this->Row < height; this->Row += windowHeight)
  {
    SampleWindow window;
    window.Level = level;
    window.Row = this->Row;
    window.Height = std::min(windowHeight, height - this->Row);
    for (window.Column = 0; window.Column < width; window.Column += windowWidth)
    {
      window.Width = std::min(windowWidth, width - window.Column);
      if (!(level == 0 ? this->CopyWindow(window, error) : this->Reduce(window, error)))
      {
        return Result::Failed;
      }
      const auto samples = static_cast<double>(window.GetNumberOfSamples());
      this->DoneSamples += samples;
      unflushed += samples * GDALGetDataTypeSizeBytes(this->Type);
      if (!this->Report(Step::Copy, this->DoneSamples / this->AllSamples))
      {
        return this->Flush(level, this->Row, error) ? Result::Stopped : Result::Failed;
      }
    }
    if (unflushed > BytesPerFlush)
    {
      unflushed = 0.0;
      if (!this->Flush(level, this->Row + windowHeight, error))
      {
        return Result::Failed;
      }
    }
  }
  return this->Flush(level + 1, 0, error) ? Result::Done : Result::Failed;
}

bool PyramidWriter::CopyWindow(const SampleWindow& window, std::string& error)
{
  GDALSession session;
  const GDALRasterBandH source = GDALGetRasterBand(this->Source.get(), 1);
  if (this->IsAbsent(source, window))
  {
    return true;
  }
  std::vector<unsigned char> samples(
    window.GetNumberOfSamples() * GDALGetDataTypeSizeBytes(this->Type));
  if (GDALRasterIO(source, GF_Read, window.Column, window.Row, window.Width, window.Height,
        samples.data(), window.Width, window.Height, this->Type, 0, 0) != CE_None ||
    session.HasErrors())
  {
    error = session.Messages("GDAL cannot read the input");
    return false;
  }
  if (GDALRasterIO(this->GetBand(0), GF_Write, window.Column, window.Row, window.Width,
        window.Height, samples.data(), window.Width, window.Height, this->Type, 0, 0) != CE_None ||
    session.HasErrors())
  {
    error = session.Messages("GDAL cannot write the samples");
    return false;
  }
  return true;
}

bool PyramidWriter::Reduce(const SampleWindow& window, std::string& error)
{
  GDALSession session;
  const GDALRasterBandH source = this->GetBand(window.Level - 1);
  SampleWindow fine;
  fine.Level = window.Level - 1;
  fine.Column = 2 * window.Column;
  fine.Row = 2 * window.Row;
  fine.Width = std::min(2 * window.Width, GetLevelSize(this->Width, fine.Level) - fine.Column);
  fine.Height = std::min(2 * window.Height, GetLevelSize(this->Height, fine.Level) - fine.Row);
  if (this->IsAbsent(source, fine))
  {
    return true;
  }
  std::vector<double> samples(fine.GetNumberOfSamples());
  if (GDALRasterIO(source, GF_Read, fine.Column, fine.Row, fine.Width, fine.Height, samples.data(),
        fine.Width, fine.Height, GDT_Float64, 0, 0) != CE_None ||
    session.HasErrors())
  {
    error = session.Messages("GDAL cannot read the file again");
    return false;
  }
  int isDeclared = 0;
  const double declared = GDALGetRasterNoDataValue(source, &isDeclared);
  const double noData =
    isDeclared && this->Type == GDT_Float32 ? GetStoredNoData<float>(declared) : declared;
  const bool isFloat = this->Type == GDT_Float32 || this->Type == GDT_Float64;
  std::vector<double> means(window.GetNumberOfSamples());
  for (int row = 0; row < window.Height; ++row)
  {
    for (int column = 0; column < window.Width; ++column)
    {
      double sum = 0.0;
      int number = 0;
      double first = isDeclared ? noData : std::numeric_limits<double>::quiet_NaN();
      for (int y = 2 * row; y < std::min(2 * row + 2, fine.Height); ++y)
      {
        for (int x = 2 * column; x < std::min(2 * column + 2, fine.Width); ++x)
        {
          const double sample = samples[static_cast<std::size_t>(y) * fine.Width + x];
          if (std::isfinite(sample) && !(isDeclared && sample == noData))
          {
            first = number == 0 ? sample : first;
            sum += sample;
            ++number;
          }
        }
      }
      double mean = number > 0 ? sum / number : first;
      mean = isFloat || number == 0 ? mean : std::round(mean);
      // A mean that equals the no-data value would be a hole.
      means[static_cast<std::size_t>(row) * window.Width + column] =
        isDeclared && number > 0 && mean == noData ? first : mean;
    }
  }
  if (GDALRasterIO(this->GetBand(window.Level), GF_Write, window.Column, window.Row, window.Width,
        window.Height, means.data(), window.Width, window.Height, GDT_Float64, 0, 0) != CE_None ||
    session.HasErrors())
  {
    error = session.Messages("GDAL cannot write the samples");
    return false;
  }
  return true;
}

bool PyramidWriter::Flush(int level, int row, std::string& error)
{
  GDALSession session;
  GDALFlushCache(this->Target.get());
  if (session.HasErrors())
  {
    error = session.Messages("");
    return false;
  }
  error = AtomicFile::Write(this->JournalName,
    this->MakeJournalHeader() + std::to_string(level) + ' ' + std::to_string(row) + '\n');
  return error.empty();
}

PyramidWriter::Result PyramidWriter::CloseTarget(std::string& error)
{
  GDALSession session;
  this->Target.reset();
  error = session.Messages("");
  return error.empty() ? Result::Done : Result::Failed;
}

// The index of the hidden file is that of the target: a rename does not change the version of a
// file.
PyramidWriter::Result PyramidWriter::WriteIndex(std::string& error)
{
  const std::unique_ptr<PyramidFile> file = PyramidFile::Open(this->PartialName, error);
  if (!file)
  {
    return Result::Failed;
  }
  const std::string indexName = this->TargetName + PyramidIndex::FileExtension;
  const std::string signature = file->GetSignature();
  PyramidIndex index(file->GetSizes());
  if (index.Read(indexName, signature)) // the last run was interrupted afterwards
  {
    return Result::Done;
  }
  index = PyramidIndex(file->GetSizes());
  std::atomic<bool> abort{ false };
  PyramidIndexBuilder builder(*file, abort);
  const auto build = [&]
  {
    try
    {
      const int threads = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
      builder.Build(threads, index, error);
    }
    catch (const std::bad_alloc&)
    {
      error = "there is not enough memory to index it";
    }
  };
  try
  {
    const std::future<void> end = std::async(std::launch::async, build);
    while (end.wait_for(std::chrono::milliseconds(50)) != std::future_status::ready)
    {
      abort = abort || !this->Report(Step::Index, builder.GetProgress());
    }
  }
  catch (const std::system_error&)
  {
    build(); // the system allows no more threads
  }
  if (abort || !this->Report(Step::Index, 1.0))
  {
    return Result::Stopped;
  }
  if (error.empty())
  {
    error = index.Write(indexName, signature);
    error = error.empty() ? "" : "its index: " + error;
  }
  return error.empty() ? Result::Done : Result::Failed;
}

PyramidWriter::Result PyramidWriter::Publish(std::string& error)
{
  const int descriptor = open(this->PartialName.c_str(), O_RDWR | O_CLOEXEC);
  const bool isOnDisk = descriptor >= 0 && fsync(descriptor) == 0;
  if (!isOnDisk)
  {
    error = std::strerror(errno);
  }
  if (descriptor >= 0)
  {
    close(descriptor);
  }
  std::error_code failure;
  if (isOnDisk)
  {
    fs::rename(fs::u8path(this->PartialName), fs::u8path(this->TargetName), failure);
    error = failure ? failure.message() : "";
  }
  if (!error.empty())
  {
    return Result::Failed;
  }
  fs::remove(fs::u8path(this->JournalName), failure);
  return Result::Done;
}
}
