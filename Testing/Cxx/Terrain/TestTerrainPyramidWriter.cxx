// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkTerrainPyramidWriter promises equal samples and metadata, overviews that are means of the
// samples with data, sparse files that stay sparse, and a run that goes on after an interruption.
#include "RelevoCheck.h"
#include "RelevoRasterFiles.h"

#include "vtkCallbackCommand.h"
#include "vtkNew.h"
#include "vtkTerrainPyramid.h"
#include "vtkTerrainPyramidWriter.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>

#include <sys/stat.h>

namespace
{
namespace fs = std::filesystem;

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

// A band as GDAL reads it.
struct Band
{
  int Width = 0;
  int Height = 0;
  std::vector<double> Values;

  double At(int column, int row) const
  {
    return this->Values[static_cast<std::size_t>(row) * this->Width + column];
  }
};

Band ReadBand(GDALRasterBandH from)
{
  Band band;
  band.Width = GDALGetRasterBandXSize(from);
  band.Height = GDALGetRasterBandYSize(from);
  band.Values.resize(static_cast<std::size_t>(band.Width) * band.Height);
  if (GDALRasterIO(from, GF_Read, 0, 0, band.Width, band.Height, band.Values.data(), band.Width,
        band.Height, GDT_Float64, 0, 0) != CE_None)
  {
    band.Values.clear();
  }
  return band;
}

bool AreSame(double a, double b)
{
  return a == b || (std::isnan(a) && std::isnan(b));
}

// The mean of the samples with data of 2 x 2.
double GetMean(const Band& fine, int column, int row, double noData)
{
  double sum = 0.0;
  int number = 0;
  for (int y = 2 * row; y < std::min(2 * row + 2, fine.Height); ++y)
  {
    for (int x = 2 * column; x < std::min(2 * column + 2, fine.Width); ++x)
    {
      const double value = fine.At(x, y);
      if (!AreSame(value, noData))
      {
        sum += value;
        ++number;
      }
    }
  }
  return number > 0 ? sum / number : noData;
}

void CheckPyramid(RelevoCheck& check, const RelevoRaster& raster, const std::string& name)
{
  GDALDatasetH dataset = GDALOpen(name.c_str(), GA_ReadOnly);
  if (!CHECK(dataset != nullptr))
  {
    return;
  }
  GDALRasterBandH band = GDALGetRasterBand(dataset, 1);
  CHECK_EQUAL(GDALGetRasterDataType(band), raster.Type);
  int blockWidth = 0;
  int blockHeight = 0;
  GDALGetBlockSize(band, &blockWidth, &blockHeight);
  CHECK_EQUAL(blockWidth, 256);
  CHECK_EQUAL(blockHeight, 256);
  double transform[6];
  GDALGetGeoTransform(dataset, transform);
  CHECK(std::equal(transform, transform + 6, raster.Transform.begin()));
  CHECK(std::string(GDALGetProjectionRef(dataset)).find("WGS 84") != std::string::npos);
  CHECK_EQUAL(GDALGetRasterScale(band, nullptr), raster.Scale.value_or(1.0));
  CHECK_EQUAL(GDALGetRasterOffset(band, nullptr), raster.Offset.value_or(0.0));
  CHECK_EQUAL(std::string(GDALGetRasterUnitType(band)), raster.Unit);
  int isDeclared = 0;
  const double noData = GDALGetRasterNoDataValue(band, &isDeclared);
  CHECK_EQUAL(isDeclared != 0, raster.NoData.has_value());

  Band fine = ReadBand(band);
  CHECK(std::equal(fine.Values.begin(), fine.Values.end(), raster.Values.begin(), &AreSame));
  const bool isFloat = raster.Type == GDT_Float32;
  for (int i = 0; i < GDALGetOverviewCount(band); ++i)
  {
    CHECK_CASE(i);
    const Band coarse = ReadBand(GDALGetOverview(band, i));
    CHECK_EQUAL(coarse.Width, (fine.Width + 1) / 2);
    CHECK_EQUAL(coarse.Height, (fine.Height + 1) / 2);
    int different = 0;
    for (int row = 0; row < coarse.Height; ++row)
    {
      for (int column = 0; column < coarse.Width; ++column)
      {
        const double value = coarse.At(column, row);
        const double mean = GetMean(fine, column, row, isDeclared ? noData : NaN);
        const bool isMissing = AreSame(mean, isDeclared ? noData : NaN);
        const double tolerance = isFloat ? 1e-3 : 0.5;
        different +=
          (isMissing ? AreSame(value, mean) : std::abs(value - mean) <= tolerance) ? 0 : 1;
      }
    }
    CHECK_EQUAL(different, 0);
    fine = coarse;
  }
  CHECK_LESS_EQUAL(std::max(fine.Width, fine.Height), 256);
  GDALClose(dataset);
}

RelevoRaster MakeRaster(int width, int height, GDALDataType type, bool hasNoData)
{
  RelevoRaster raster;
  raster.Width = width;
  raster.Height = height;
  raster.Type = type;
  raster.Transform = { 10.0, 0.01, 0.0, 50.0, 0.0, -0.01 };
  raster.CoordinateSystem = "EPSG:4326";
  raster.Unit = "ft";
  raster.SetValues([=](int, int column, int row)
    { return std::floor(900.0 * std::sin(0.013 * column) * std::cos(0.021 * row)); });
  if (hasNoData)
  {
    raster.NoData = -32768.0;
    for (std::size_t i = 0; i < raster.Values.size(); ++i)
    {
      raster.Values[i] = i / 41 % 5 == 0 ? -32768.0 : raster.Values[i];
    }
  }
  return raster;
}

void TestRasters(RelevoCheck& check, const RelevoTestFolders& folders)
{
  const std::string input = folders.File("TerrainPyramidWriterIn.tif");
  const std::string output = folders.File("TerrainPyramidWriterOut.tif");
  struct Case
  {
    const char* Name;
    int Width;
    int Height;
    GDALDataType Type;
    bool HasNoData;
    int Compression;
  };
  const Case cases[] = {
    { "int16", 1111, 707, GDT_Int16, true, vtkTerrainPyramidWriter::DEFLATE },
    { "float", 600, 1300, GDT_Float32, true, vtkTerrainPyramidWriter::LZW },
    { "byte", 520, 300, GDT_Byte, false, vtkTerrainPyramidWriter::NONE },
    { "no overviews", 100, 256, GDT_Int16, false, vtkTerrainPyramidWriter::DEFLATE },
    { "one row", 9000, 1, GDT_Int32, false, vtkTerrainPyramidWriter::DEFLATE },
  };
  const auto listHidden = [&folders]()
  {
    std::vector<fs::path> hidden;
    for (const auto& entry : fs::directory_iterator(folders.Output))
    {
      if (entry.path().filename().string().rfind(".TerrainPyramidWriter", 0) == 0)
      {
        hidden.push_back(entry.path());
      }
    }
    return hidden;
  };
  for (const fs::path& path : listHidden())
  {
    fs::remove(path); // of a run that was killed
  }
  for (const Case& one : cases)
  {
    CHECK_CASE(one.Name);
    RelevoRaster raster = MakeRaster(one.Width, one.Height, one.Type, one.HasNoData);
    if (one.Type == GDT_Byte)
    {
      for (double& value : raster.Values)
      {
        value = std::floor(std::abs(value) / 4.0);
      }
      raster.Scale = 0.5;
      raster.Offset = 10.0;
    }
    fs::remove(output);
    CHECK(raster.Write(input));
    vtkNew<vtkTerrainPyramidWriter> writer;
    RelevoErrors errors(writer);
    writer->SetInputFileName(input.c_str());
    writer->SetFileName(output.c_str());
    writer->SetCompression(one.Compression);
    CHECK(writer->Write());
    CHECK(errors.None());
    CheckPyramid(check, raster, output);
    CHECK_EQUAL(writer->GetStep(), static_cast<int>(vtkTerrainPyramidWriter::INDEX));
    vtkNew<vtkTerrainPyramid> pyramid;
    pyramid->SetFileName(output.c_str());
    CHECK(pyramid->Update());
    CHECK(pyramid->IsErrorKnown()); // from the index of the writer
  }
  // Nothing is left beside the file.
  CHECK(listHidden().empty());
}

// A mean that equals the no-data value would be a hole.
void TestNoDataMean(RelevoCheck& check, const RelevoTestFolders& folders)
{
  const std::string input = folders.File("TerrainPyramidWriterMean.tif");
  const std::string output = folders.File("TerrainPyramidWriterMeanOut.tif");
  RelevoRaster raster = MakeRaster(400, 400, GDT_Int16, false);
  raster.NoData = 0.0;
  raster.SetValues([](int, int column, int) { return column % 2 == 0 ? -7 : 7; });
  CHECK(raster.Write(input));
  vtkNew<vtkTerrainPyramidWriter> writer;
  writer->SetInputFileName(input.c_str());
  writer->SetFileName(output.c_str());
  CHECK(writer->Write());
  GDALDatasetH dataset = GDALOpen(output.c_str(), GA_ReadOnly);
  const Band coarse = ReadBand(GDALGetOverview(GDALGetRasterBand(dataset, 1), 0));
  CHECK_EQUAL(std::count(coarse.Values.begin(), coarse.Values.end(), 0.0), 0);
  GDALClose(dataset);
}

std::string ReadBytes(const std::string& name)
{
  std::ifstream stream(name, std::ios::binary);
  return { std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>() };
}

// If the index is interrupted, the output does not appear, and the next run only makes the index:
// it is the one that vtkTerrainPyramid makes.
void TestIndex(RelevoCheck& check, const RelevoTestFolders& folders)
{
  const std::string input = folders.File("TerrainPyramidWriterIndex.tif");
  const std::string output = folders.File("TerrainPyramidWriterIndexOut.tif");
  const std::string index = output + ".relevo-index";
  CHECK(MakeRaster(1700, 1900, GDT_Int16, true).Write(input));
  fs::remove(output);
  fs::remove(index);
  vtkNew<vtkTerrainPyramidWriter> writer;
  RelevoErrors errors(writer);
  writer->SetInputFileName(input.c_str());
  writer->SetFileName(output.c_str());
  struct State
  {
    bool IsToStop = true;
    int Copied = 0;
    double Last = 0.0;
  } state;
  vtkNew<vtkCallbackCommand> progress;
  progress->SetClientData(&state);
  progress->SetCallback(
    [](vtkObject* caller, unsigned long, void* client, void* data)
    {
      auto* current = static_cast<vtkTerrainPyramidWriter*>(caller);
      auto* known = static_cast<State*>(client);
      known->Copied += current->GetStep() == vtkTerrainPyramidWriter::COPY ? 1 : 0;
      known->Last = *static_cast<double*>(data);
      if (known->IsToStop && current->GetStep() == vtkTerrainPyramidWriter::INDEX)
      {
        current->AbortExecuteOn();
      }
    });
  writer->AddObserver(vtkCommand::ProgressEvent, progress);
  CHECK(!writer->Write());
  CHECK_GREATER(state.Copied, 0);
  CHECK(!fs::exists(output));
  CHECK(!fs::exists(index));
  state = State{ false };
  CHECK(writer->Write());
  CHECK_EQUAL(state.Copied, 0);
  CHECK_EQUAL(state.Last, 1.0);
  CHECK(errors.None());
  const std::string bytes = ReadBytes(index);
  CHECK_GREATER(bytes.size(), 1000);
  fs::remove(index);
  vtkNew<vtkTerrainPyramid> pyramid;
  pyramid->SetFileName(output.c_str());
  CHECK(pyramid->Update());
  CHECK(pyramid->WaitForIndex());
  CHECK(ReadBytes(index) == bytes);

  fs::remove(index);
  writer->WriteIndexOff();
  CHECK(writer->Write());
  CHECK(!fs::exists(index));
}

// Stopped at any fraction, the next run goes on and gives the same file.
void TestResume(RelevoCheck& check, const RelevoTestFolders& folders)
{
  const std::string input = folders.File("TerrainPyramidWriterStop.tif");
  const std::string output = folders.File("TerrainPyramidWriterStopOut.tif");
  const RelevoRaster raster = MakeRaster(1700, 1900, GDT_Int16, true);
  CHECK(raster.Write(input));
  for (const double stop : { 0.0, 0.3, 0.6, 0.85, 0.99 })
  {
    CHECK_CASE(stop);
    fs::remove(output);
    vtkNew<vtkTerrainPyramidWriter> writer;
    RelevoErrors errors(writer);
    writer->SetInputFileName(input.c_str());
    writer->SetFileName(output.c_str());
    writer->WriteIndexOff();
    struct State
    {
      double Stop;
      double First = -1.0;
    } state{ stop };
    vtkNew<vtkCallbackCommand> progress;
    progress->SetClientData(&state);
    progress->SetCallback(
      [](vtkObject* caller, unsigned long, void* client, void* data)
      {
        State& current = *static_cast<State*>(client);
        const double fraction = *static_cast<double*>(data);
        current.First = current.First < 0.0 ? fraction : current.First;
        if (fraction >= current.Stop)
        {
          static_cast<vtkTerrainPyramidWriter*>(caller)->AbortExecuteOn();
        }
      });
    writer->AddObserver(vtkCommand::ProgressEvent, progress);
    CHECK(!writer->Write());
    CHECK(!fs::exists(output));
    state = State{ 2.0 };
    CHECK(writer->Write());
    if (stop > 0.5)
    {
      CHECK_GREATER(state.First, 0.25); // it does not begin anew
    }
    CHECK(errors.None());
    CheckPyramid(check, raster, output);
  }
}

void TestSparse(RelevoCheck& check, const RelevoTestFolders& folders)
{
  const std::string input = folders.File("TerrainPyramidWriterSparse.tif");
  const std::string output = folders.File("TerrainPyramidWriterSparseOut.tif");
  fs::remove(output);
  constexpr int size = 1 << 15;
  char** options = nullptr;
  for (const char* option : { "TILED=YES", "SPARSE_OK=TRUE", "BIGTIFF=YES" })
  {
    options = CSLAddString(options, option);
  }
  GDALDatasetH dataset =
    GDALCreate(GDALGetDriverByName("GTiff"), input.c_str(), size, size, 1, GDT_Float32, options);
  CSLDestroy(options);
  GDALRasterBandH band = GDALGetRasterBand(dataset, 1);
  GDALSetRasterNoDataValue(band, -9999.0);
  std::vector<float> block(256 * 256, 12.0f);
  CHECK(GDALRasterIO(band, GF_Write, 5120, 20480, 256, 256, block.data(), 256, 256, GDT_Float32, 0,
          0) == CE_None);
  GDALClose(dataset);
  vtkNew<vtkTerrainPyramidWriter> writer;
  writer->SetInputFileName(input.c_str());
  writer->SetFileName(output.c_str());
  CHECK(writer->Write());
  // Offsets and sizes of 16384 tiles and a third more, and one tile for each level.
  CHECK_LESS(fs::file_size(output), 16u * 22000u + 100000u);
  vtkNew<vtkTerrainPyramid> pyramid;
  pyramid->SetFileName(output.c_str());
  CHECK(pyramid->Update());
  CHECK(pyramid->WaitForIndex());
  CHECK_EQUAL(pyramid->GetNumberOfLevels(), 8);
  CHECK_EQUAL(pyramid->GetRange()[0], 12.0);
  CHECK_EQUAL(pyramid->GetElevation(5120.5, size - 20480.5), 12.0);
  CHECK(std::isnan(pyramid->GetElevation(0.5, 0.5)));
  fs::remove(output);
  fs::remove(input);
}

void TestErrors(RelevoCheck& check, const RelevoTestFolders& folders)
{
  vtkNew<vtkTerrainPyramidWriter> writer;
  RelevoErrors errors(writer);
  CHECK(!writer->Write());
  CHECK(errors.Said("SetInputFileName()"));
  writer->SetCompression(9);
  CHECK(errors.Said("Compression must be one of"));
  const std::string input = folders.File("TerrainPyramidWriterErrors.tif");
  const std::string output = folders.File("TerrainPyramidWriterErrorsOut.tif");
  fs::remove(output);
  RelevoRaster raster = MakeRaster(300, 200, GDT_Int16, false);
  CHECK(raster.Write(input));
  writer->SetInputFileName(folders.File("missing.tif").c_str());
  writer->SetFileName(output.c_str());
  CHECK(!writer->Write());
  CHECK(errors.Said("missing.tif: the file does not exist"));
  writer->SetInputFileName(input.c_str());
  writer->SetFileName(folders.File("no/such/folder/out.tif").c_str());
  CHECK(!writer->Write());
  CHECK(errors.Said("no/such/folder/out.tif"));

  writer->SetFileName(input.c_str());
  CHECK(!writer->Write());
  CHECK(errors.Said("it is the input"));
  const std::string pipe = folders.File("TerrainPyramidWriterPipe");
  fs::remove(pipe);
  CHECK_EQUAL(mkfifo(pipe.c_str(), 0600), 0);
  writer->SetFileName(pipe.c_str());
  CHECK(!writer->Write());
  CHECK(errors.Said("it is not a regular file"));
  CHECK(fs::is_fifo(pipe)); // a rename would have replaced it
  fs::remove(pipe);
  const std::string link = folders.File("TerrainPyramidWriterLink.tif");
  fs::remove(link);
  CHECK(raster.Write(output));
  fs::create_symlink(fs::absolute(output), link);
  writer->SetFileName(link.c_str());
  CHECK(writer->Write());
  CHECK(fs::is_symlink(link));
  fs::remove(link);
  fs::remove(output);
  raster.Mask.assign(raster.Values.size(), 255);
  raster.Mask[7] = 0;
  CHECK(raster.Write(input));
  writer->SetFileName(output.c_str());
  CHECK(!writer->Write());
  CHECK(errors.Said("mask"));
  raster.Mask.clear();
  raster.Options = { "COMPRESS=DEFLATE" };
  CHECK(raster.Write(input));
  const std::string cut = folders.File("TerrainPyramidWriterCut.tif");
  RelevoTruncate(input, cut, 0.5);
  writer->SetInputFileName(cut.c_str());
  CHECK(!writer->Write());
  CHECK(errors.Said("TerrainPyramidWriter"));
  CHECK(!fs::exists(output));
}
}

int TestTerrainPyramidWriter(int argc, char* argv[])
{
  RelevoCheck check;
  const RelevoTestFolders folders(argc, argv);
  TestRasters(check, folders);
  TestNoDataMean(check, folders);
  TestIndex(check, folders);
  TestResume(check, folders);
  TestSparse(check, folders);
  TestErrors(check, folders);
  return check.GetResult();
}
