// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkTerrainFiles.h"

#include "BenchmarkFractal.h"
#include "BenchmarkRaster.h"
#include "vtkTerrainPyramid.h"
#include "vtkTerrainPyramidWriter.h"

#include "vtkNew.h"

#include <gdal.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <system_error>
#include <unistd.h> // for access

namespace
{
constexpr int TerrainTileSize = 512;

bool WritePyramid(const std::string& from, const std::string& to)
{
  std::error_code error;
  std::filesystem::remove(to + ".relevo-index", error);
  vtkNew<vtkTerrainPyramidWriter> writer;
  writer->SetInputFileName(from.c_str());
  writer->SetFileName(to.c_str());
  const bool isWritten = writer->Write();
  std::filesystem::remove(from, error);
  return isWritten;
}

// Writes squares of a sparse raster.
bool WriteSquares(const std::string& fileName, int size, int squareSize,
  const std::vector<std::array<int, 2>>& squares)
{
  GDALAllRegister();
  const char* const settings[] = { "TILED=YES", "BLOCKXSIZE=512", "BLOCKYSIZE=512", "BIGTIFF=YES",
    "SPARSE_OK=TRUE", nullptr };
  GDALDatasetH file = GDALCreate(GDALGetDriverByName("GTiff"), fileName.c_str(), size, size, 1,
    GDT_Int16, const_cast<char**>(settings));
  if (!file)
  {
    return false;
  }
  double transform[6] = { 0.0, 30.0, 0.0, 5000000.0, 0.0, -30.0 };
  GDALSetGeoTransform(file, transform);
  GDALSetProjection(file, BenchmarkFractal::CoordinateSystem);
  const BenchmarkFractal fractal;
  bool isWritten = true;
  for (const std::array<int, 2>& square : squares)
  {
    const int width = std::min(squareSize, size - square[0]);
    for (int row = square[1]; row < std::min(square[1] + squareSize, size); row += TerrainTileSize)
    {
      const int height = std::min(TerrainTileSize, size - row);
      std::vector<short> samples = fractal.GetSamples({ { square[0], row } }, width, height);
      isWritten = isWritten &&
        GDALRasterIO(GDALGetRasterBand(file, 1), GF_Write, square[0], row, width, height,
          samples.data(), width, height, GDT_Int16, 0, 0) == CE_None;
    }
  }
  GDALClose(file);
  return isWritten;
}
}

std::string GetTerrainFile(const BenchmarkOptions& options, const std::string& name)
{
  std::error_code error;
  std::filesystem::path folder = std::filesystem::path(options.ProgramFolder) / "benchmark-terrain";
  std::filesystem::create_directories(folder, error);
  if (access(folder.c_str(), W_OK) != 0)
  {
    folder = std::filesystem::temp_directory_path() / "relevo-benchmark-terrain";
    std::filesystem::create_directories(folder, error);
  }
  return (folder / name).string();
}

bool WriteTerrainPyramid(const BenchmarkRaster& raster, const std::string& fileName)
{
  const std::string plain = fileName + ".plain.tif";
  return raster.Write(plain) && WritePyramid(plain, fileName);
}

bool WriteFractal(const std::string& fileName, int size, bool isPlain)
{
  if (std::filesystem::exists(fileName))
  {
    return true;
  }
  std::cerr << "terrain: writing " << fileName << std::endl;
  const std::string plain = fileName + ".plain.tif";
  if (!WriteSquares(plain, size, size, { { { 0, 0 } } }))
  {
    return false;
  }
  if (isPlain)
  {
    std::error_code error;
    std::filesystem::rename(plain, fileName, error);
    return !error;
  }
  return WritePyramid(plain, fileName);
}

bool WriteSparseFractal(const std::string& fileName, int size, int patchSize,
  const std::vector<std::array<int, 2>>& patches)
{
  if (std::filesystem::exists(fileName))
  {
    return true;
  }
  std::cerr << "terrain: writing " << fileName << std::endl;
  const std::string plain = fileName + ".plain.tif";
  return WriteSquares(plain, size, patchSize, patches) && WritePyramid(plain, fileName);
}

vtkSmartPointer<vtkTerrainPyramid> OpenTerrain(const std::string& fileName)
{
  auto pyramid = vtkSmartPointer<vtkTerrainPyramid>::New();
  pyramid->SetFileName(fileName.c_str());
  return pyramid->Update() && pyramid->WaitForIndex() ? pyramid : nullptr;
}
