// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkTerrainSizes.h"

#include "BenchmarkMeasure.h"
#include "BenchmarkReport.h"
#include "BenchmarkSlowFiles.h"
#include "BenchmarkTerrainFiles.h"
#include "BenchmarkView.h"
#include "vtkTerrainMapper.h"
#include "vtkTerrainPyramid.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkNew.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <limits>
#include <system_error>

namespace
{
constexpr double Mebibyte = 1048576.0;

// Places the camera for a part of the flight, from 0 to 1, over the middle of the raster. The first
// picture shows all of it.
void Fly(vtkCamera* camera, const double bounds[6], double time)
{
  const double height = 2500.0;
  const double x = 0.5 * (bounds[0] + bounds[1]) + 40000.0 * (time - 0.5);
  const double y = 0.5 * (bounds[2] + bounds[3]) + 8000.0 * std::sin(7.0 * time);
  camera->SetPosition(x, y, bounds[5] + height);
  camera->SetFocalPoint(x + 9000.0, y + 4000.0 * std::sin(11.0 * time), bounds[4]);
  camera->SetViewUp(0.0, 0.0, 1.0);
}

void AddIndexRow(
  BenchmarkTable& table, const std::string& name, const std::string& fileName, double stored)
{
  std::cerr << "terrain: index of " << fileName << std::endl;
  std::error_code error;
  std::filesystem::remove(fileName + ".relevo-index", error);
  const auto result = RunInOwnProcess({ "terrain", "index", fileName });
  if (result.size() == 2)
  {
    const auto bytes =
      static_cast<double>(std::filesystem::file_size(fileName + ".relevo-index", error));
    table.AddRow({ name, 1e-6 * stored, result[0], 1e9 * result[0] / stored, 1e-6 * bytes,
      100.0 * bytes / (2.0 * stored), result[1] / Mebibyte });
  }
}

struct Flight
{
  std::string Name;
  std::string FileName;
  int MemoryLimit; // in MiB
  int Delay;       // of a read in milliseconds
};

void AddFlightRow(BenchmarkTable& table, const Flight& flight, const std::string& base, int frames)
{
  std::cerr << "terrain: flight over " << flight.FileName << std::endl;
  const auto result = RunInOwnProcess({ "terrain", "flight", flight.FileName, base,
    std::to_string(flight.MemoryLimit), std::to_string(frames), std::to_string(flight.Delay) });
  if (result.size() == 7)
  {
    table.AddRow(
      { flight.Name, static_cast<double>(flight.MemoryLimit), static_cast<double>(flight.Delay),
        result[0], result[1], 1e3 * result[2], 1e3 * result[3], result[3] / result[2], result[4],
        result[6], result[5] / Mebibyte, result[5] / Mebibyte / flight.MemoryLimit });
  }
}
}

std::vector<double> MeasureTerrainIndex(const std::vector<std::string>& arguments)
{
  const double before = GetResidentMemory().Current;
  const Stopwatch stopwatch;
  if (!OpenTerrain(arguments.at(0)))
  {
    return {};
  }
  return { stopwatch.GetSeconds(), GetResidentMemory().Peak - before };
}

std::vector<double> MeasureTerrainFlight(const std::vector<std::string>& arguments)
{
  const double unknown = std::numeric_limits<double>::quiet_NaN();
  const int delay = std::atoi(arguments.at(4).c_str());
  const std::string fileName = (delay > 0 ? BenchmarkSlowFiles::Prefix : "") + arguments.at(0);
  BenchmarkSlowFiles::Install();
  const int frames = std::atoi(arguments.at(3).c_str());
  const bool isQuick = frames < 100;
  BenchmarkView view(isQuick ? 160 : 1280, isQuick ? 100 : 800);
  vtkCamera* camera = view.GetRenderer()->GetActiveCamera();
  // A small terrain compiles the shaders. It has as many triangles as a picture of the flight, as
  // Mesa's software renderer buffers them.
  vtkNew<vtkTerrainMapper> small;
  small->SetPyramid(OpenTerrain(arguments.at(1)));
  small->SetScreenSpaceError(0.05);
  small->SetLoadingModeToComplete();
  const vtkSmartPointer<vtkActor> smallActor = view.AddActor(small);
  view.GetRenderer()->ResetCamera(small->GetBounds());
  view.TimeFrame();
  view.GetRenderer()->RemoveActor(smallActor);
  small->ReleaseGraphicsResources(view.GetRenderer()->GetVTKWindow());
  if (delay > 0 && !OpenTerrain(fileName)) // before reads are slow, for the index
  {
    return {};
  }
  BenchmarkSlowFiles::SetDelay(delay);
  const double before = GetResidentMemory().Current;
  const Stopwatch stopwatch;
  vtkNew<vtkTerrainPyramid> pyramid;
  pyramid->SetFileName(fileName.c_str());
  vtkNew<vtkTerrainMapper> mapper;
  mapper->SetPyramid(pyramid);
  mapper->SetMemoryLimit(static_cast<vtkTypeInt64>(std::atoi(arguments.at(2).c_str())) << 20);
  view.AddActor(mapper);
  double bounds[6];
  std::copy_n(mapper->GetBounds(), 6, bounds);
  Fly(camera, bounds, 0.0);
  view.TimeFrame();
  const double first = stopwatch.GetSeconds();
  mapper->SetLoadingModeToComplete();
  view.TimeFrame();
  const double complete = stopwatch.GetSeconds();
  const double error = mapper->GetScreenSpaceErrorInUse();
  const auto triangles = static_cast<double>(mapper->GetNumberOfDrawnTriangles());
  mapper->SetLoadingModeToBackground();
  std::vector<double> times;
  for (int frame = 0; frame < frames; ++frame)
  {
    Fly(camera, bounds, static_cast<double>(frame) / frames);
    times.push_back(view.TimeFrame());
  }
  std::sort(times.begin(), times.end());
  const double percentile = times.empty() ? unknown : times[(times.size() * 99) / 100];
  return { first, complete, GetMedian(times), percentile, error, GetResidentMemory().Peak - before,
    triangles };
}

void AddTerrainSizes(const BenchmarkOptions& options, const AddTable& addTable)
{
  BenchmarkTable indexTable("terrain-index", "Time to index pyramids",
    { { "raster", "raster", 0 }, { "stored_millions", "stored samples, M", 1 },
      { "seconds", "time, s", 2 }, { "ns_per_sample", "ns per stored sample", 1 },
      { "index_mb", "index, MB", 2 }, { "index_percent", "index, % of the samples", 2 },
      { "memory_mib", "memory, MiB", 0 } });
  BenchmarkTable flightTable("terrain-flight", "First picture, flight and memory",
    { { "raster", "raster", 0 }, { "limit_mib", "limit, MiB", 0 },
      { "delay_ms", "delay of a read, ms", 0 }, { "first_s", "first picture, s", 2 },
      { "complete_s", "complete picture, s", 2 }, { "median_ms", "frame, median, ms", 1 },
      { "percentile_ms", "frame, 99th percentile, ms", 1 }, { "ratio", "percentile / median", 2 },
      { "error", "error of the complete picture, pixels", 2 }, { "triangles", "its triangles", 0 },
      { "memory_mib", "peak memory over base, MiB", 0 }, { "of_limit", "memory / limit", 2 } });
  const int size = options.Quick ? 1024 : 32768;
  const int sparseSize = options.Quick ? 4096 : 1 << 19;
  const int patchSize = options.Quick ? 256 : 4096;
  const int frames = options.Quick ? 10 : 500;
  const std::string dense = GetTerrainFile(options, "fractal-" + std::to_string(size) + ".tif");
  const std::string base = GetTerrainFile(options, "fractal-64.tif");
  if (!WriteFractal(dense, size) || !WriteFractal(base, 64))
  {
    indexTable.AddNote("No file can be written to " + dense + ".");
    addTable(indexTable);
    return;
  }
  const std::string name = std::to_string(size) + " x " + std::to_string(size);
  AddIndexRow(indexTable, name, dense, static_cast<double>(size) * size);
  std::vector<Flight> flights;
  for (const int limit : options.Quick ? std::vector<int>{ 64 } : std::vector<int>{ 512, 64 })
  {
    flights.push_back({ name, dense, limit, 0 });
    flights.push_back({ name, dense, limit, 20 });
  }
  const int middle = sparseSize / 2 - patchSize / 2;
  const int far = sparseSize / 8;
  std::vector<std::array<int, 2>> patches = { { { middle, middle } } };
  for (const int count : { 1, 4 })
  {
    for (int i = static_cast<int>(patches.size()); i < count; ++i)
    {
      patches.push_back({ { far * i, far * i } });
    }
    const std::string sparse = GetTerrainFile(
      options, "sparse-" + std::to_string(sparseSize) + "-" + std::to_string(count) + ".tif");
    const std::string sparseName =
      std::to_string(sparseSize) + " x " + std::to_string(sparseSize) + ", sparse";
    if (WriteSparseFractal(sparse, sparseSize, patchSize, patches))
    {
      AddIndexRow(
        indexTable, sparseName, sparse, static_cast<double>(patchSize) * patchSize * count);
      flights.push_back({ sparseName, sparse, 512, 0 });
    }
  }
  flights.pop_back(); // one of the sparse ones
  for (const Flight& flight : flights)
  {
    AddFlightRow(flightTable, flight, base, frames);
  }
  indexTable.AddNote("Int16 samples with overviews, DEFLATE.");
  flightTable.AddNote(
    "A process that has drawn a small terrain with about as many triangles is the base. " +
    std::to_string(frames) +
    " frames, of 1280 x 800 pixels without --quick, which load in the background. Asked: 3 s until "
    "the first "
    "picture, 2 for the percentile, and 1.1 times the limit.");
  addTable(indexTable);
  addTable(flightTable);
}
