// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Compares Relevo with VTK's classes for drawing a raster as terrain. Each way runs in a separate
// process from the file to the picture.
#include "BenchmarkMeasure.h"
#include "BenchmarkReport.h"
#include "BenchmarkView.h"
#include "Benchmarks.h"

#include "vtkActor.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkAdaptiveRefinementMapper.h"
#include "vtkDistanceDepthTagMetric.h"
#include "vtkHeightMap.h"
#include "vtkImageData.h"
#include "vtkImageDataGeometryFilter.h"
#include "vtkImageReader2.h"
#include "vtkImageReader2Factory.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkPolyDataNormals.h"
#include "vtkTerrainSource.h"
#include "vtkWarpScalar.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <unistd.h> // for getpid

namespace
{
// One unit of height in the raster, in texels.
constexpr double HeightScale = 0.05;

short GetHeight(int i, int j)
{
  double height = 1000.0;
  double amplitude = 500.0;
  for (double frequency = 0.004; frequency < 0.5; frequency *= 2.1, amplitude *= 0.5)
  {
    height += amplitude * std::sin(frequency * i + 0.7 * frequency * j) *
      std::cos(1.3 * frequency * j - 0.4 * frequency * i);
  }
  return static_cast<short>(std::lround(height));
}

// Writes an uncompressed TIFF of int16, which VTK's writer does not support.
void WriteHeightMap(const std::string& fileName, int size)
{
  std::ofstream file(fileName, std::ios::binary);
  auto write = [&file](uint32_t value, int bytes)
  {
    for (int i = 0; i < bytes; ++i)
    {
      file.put(static_cast<char>(value >> (8 * i) & 0xff));
    }
  };
  const auto side = static_cast<uint32_t>(size);
  const uint32_t tags[][2] = {
    { 256, side },            // width
    { 257, side },            // height
    { 258, 16 },              // bits per sample
    { 259, 1 },               // no compression
    { 262, 1 },               // black is zero
    { 273, 256 },             // offset of the samples
    { 277, 1 },               // samples per pixel
    { 278, side },            // rows per strip
    { 279, 2 * side * side }, // bytes
    { 339, 2 },               // signed integers
  };
  file << "II";
  write(42, 2);
  write(8, 4);
  write(std::size(tags), 2);
  for (const auto& tag : tags)
  {
    write(tag[0], 2);
    write(4, 2); // a 32-bit number
    write(1, 4);
    write(tag[1], 4);
  }
  while (file.tellp() < 256)
  {
    file.put(0);
  }
  for (int j = 0; j < size; ++j)
  {
    for (int i = 0; i < size; ++i)
    {
      write(static_cast<uint16_t>(GetHeight(i, j)), 2);
    }
  }
}

struct Pictures
{
  double First; // seconds
  double Frame;
};

Pictures Draw(BenchmarkView& view, vtkMapper* mapper, const Stopwatch& stopwatch)
{
  view.AddActor(mapper);
  view.LookAt(mapper->GetBounds());
  view.TimeFrame();
  const double first = stopwatch.GetSeconds();
  std::vector<double> frames;
  const Stopwatch limit;
  while (frames.size() < 2 || (frames.size() < 7 && limit.GetSeconds() < 5.0))
  {
    view.MoveCamera();
    frames.push_back(view.TimeFrame());
  }
  return { first, GetMedian(frames) };
}

std::vector<double> GetResult(
  vtkIdType triangles, const Pictures& pictures, const ResidentMemory& before)
{
  const ResidentMemory after = GetResidentMemory();
  return { static_cast<double>(triangles), pictures.First, pictures.Frame,
    after.Peak - before.Current, after.Current - before.Current };
}

std::vector<double> MeasureVTK(const std::string& fileName)
{
  BenchmarkView view;
  const ResidentMemory before = GetResidentMemory();
  const Stopwatch stopwatch;
  auto reader = vtkSmartPointer<vtkImageReader2>::Take(
    vtkImageReader2Factory::CreateImageReader2(fileName.c_str()));
  if (!reader)
  {
    return {};
  }
  reader->SetFileName(fileName.c_str());
  vtkNew<vtkImageDataGeometryFilter> geometry;
  geometry->SetInputConnection(reader->GetOutputPort());
  vtkNew<vtkWarpScalar> warp;
  warp->SetInputConnection(geometry->GetOutputPort());
  warp->SetScaleFactor(HeightScale);
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputConnection(warp->GetOutputPort());
  normals->SplittingOff();
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(normals->GetOutputPort());
  mapper->ScalarVisibilityOff();
  const Pictures pictures = Draw(view, mapper, stopwatch);
  const int* size = reader->GetOutput()->GetDimensions();
  return GetResult(2 * static_cast<vtkIdType>(size[0] - 1) * (size[1] - 1), pictures, before);
}

std::vector<double> MeasureRelevo(const std::string& fileName, bool allTexels)
{
  BenchmarkView view;
  const ResidentMemory before = GetResidentMemory();
  const Stopwatch stopwatch;
  vtkNew<vtkTerrainSource> source;
  source->SetFileName(fileName.c_str());
  source->SetExaggeration(HeightScale);
  source->Update();
  if (source->GetOutput()->GetNumberOfCells() == 0)
  {
    return {};
  }
  int size[2];
  source->GetHeightMap()->GetDimensions(size);
  const int texels = std::max(size[0], size[1]);
  // Levels up to one segment per texel.
  const int level = static_cast<int>(
    std::ceil(std::log2(static_cast<double>(texels) / std::min(source->GetResolution(), texels))));
  vtkNew<vtkAdaptiveRefinement> recipe;
  recipe->SetDisplacement(source->GetDisplacement());
  recipe->SetMaximumLevel(std::min(level, 7));
  if (!allTexels)
  {
    vtkNew<vtkDistanceDepthTagMetric> metric;
    recipe->SetMetric(metric);
  }
  vtkNew<vtkAdaptiveRefinementMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  mapper->SetRefinement(recipe);
  const Pictures pictures = Draw(view, mapper, stopwatch);
  // Measured before triangles over holes are counted, which may take more memory.
  const ResidentMemory after = GetResidentMemory();
  auto result = GetResult(0, pictures, before);
  result[0] = static_cast<double>(mapper->GetNumberOfDrawnTriangles());
  result[3] = after.Peak - before.Current;
  result[4] = after.Current - before.Current;
  return result;
}
}

// vtk|adaptive|full FILE -> triangles, seconds to the first picture, seconds per frame, growth of
// resident memory at its peak and at the end
std::vector<double> MeasureTerrain(const std::vector<std::string>& arguments)
{
  const std::string& way = arguments.at(0);
  const std::string& fileName = arguments.at(1);
  return way == "vtk" ? MeasureVTK(fileName) : MeasureRelevo(fileName, way == "full");
}

void RunTerrain(const BenchmarkOptions& options, const AddTable& addTable)
{
  std::string fileName = options.HeightMap;
  const bool isMade = fileName.empty();
  const int size = options.Quick ? 64 : 4096;
  if (isMade)
  {
    fileName = (std::filesystem::temp_directory_path() /
      ("relevo-benchmark-" + std::to_string(getpid()) + ".tif"))
                 .string();
    WriteHeightMap(fileName, size);
  }
  BenchmarkTable table("dem", "A height map as terrain, each way from the file to the picture",
    { { "way", "way", 0 }, { "triangles", "triangles", 0 },
      { "first_picture_s", "first picture, s", 2 }, { "frame_s", "frame, s", 3 },
      { "peak_resident_mb", "peak resident memory, MB", 0 },
      { "resident_mb", "resident, MB", 0 } });
  const std::pair<const char*, const char*> ways[] = {
    { "adaptive", "Relevo, levels by distance" },
    { "full", "Relevo, every texel" },
    { "vtk", "VTK: reader, vtkImageDataGeometryFilter, vtkWarpScalar, vtkPolyDataNormals" },
  };
  for (const auto& way : ways)
  {
    std::cerr << "dem: " << way.second << std::endl;
    const auto result = RunInOwnProcess({ "dem", way.first, fileName });
    if (result.size() != 5)
    {
      table.AddNote(std::string(way.second) + " could not draw the file.");
      continue;
    }
    table.AddRow({ std::string(way.second), result[0], result[1], result[2], 1e-6 * result[3],
      1e-6 * result[4] });
  }
  table.AddNote((isMade ? std::to_string(size) + " x " + std::to_string(size) +
                      " samples of int16, made by the benchmark, as an uncompressed TIFF. "
                        : "File: " + fileName + ". ") +
    std::string("Memory is growth over a process with an empty window."));
  addTable(table);
  if (isMade)
  {
    std::remove(fileName.c_str());
  }
}
