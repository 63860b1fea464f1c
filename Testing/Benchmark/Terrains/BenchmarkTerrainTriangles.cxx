// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkTerrainTriangles.h"

#include "BenchmarkMeasure.h"
#include "BenchmarkRaster.h"
#include "BenchmarkReport.h"
#include "BenchmarkTerrainError.h"
#include "BenchmarkTerrainFiles.h"
#include "vtkTerrainMeshSource.h"
#include "vtkTerrainPyramid.h"

#include "vtkCamera.h"
#include "vtkFloatArray.h"
#include "vtkGreedyTerrainDecimation.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace
{
vtkSmartPointer<vtkImageData> MakeHeightImage(
  const BenchmarkRaster& raster, const relevo::TerrainPlacement& placement)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  const int width = raster.GetWidth();
  const int height = raster.GetHeight();
  image->SetDimensions(width, height, 1);
  image->SetSpacing(placement.Column[0], -placement.Row[1], 1.0);
  const std::array<double, 3> corner = placement.ToWorld(0.0, height - 1.0, 0.0);
  image->SetOrigin(corner.data());
  vtkNew<vtkFloatArray> heights;
  for (int row = height - 1; row >= 0; --row)
  {
    for (int column = 0; column < width; ++column)
    {
      heights->InsertNextValue(
        raster.GetSample(column, row) * static_cast<float>(placement.HeightScale));
    }
  }
  image->GetPointData()->SetScalars(heights);
  return image;
}
}

void AddTerrainTriangles(const BenchmarkOptions& options, const AddTable& addTable)
{
  BenchmarkTable table("terrain-triangles",
    "Meshes within a vertical distance: vtkTerrainMeshSource (A) against "
    "vtkGreedyTerrainDecimation (B)",
    { { "asked", "asked, m", 0 }, { "triangles_a", "triangles of A", 0 },
      { "triangles_b", "triangles of B", 0 }, { "ratio", "A / B", 3 },
      { "error_a", "error of A, m", 2 }, { "error_b", "error of B, m", 2 }, { "a_s", "A, s", 2 },
      { "b_s", "B, s", 2 }, { "times", "time A / B", 3 } });
  const int size = options.Quick ? 65 : 1025;
  const BenchmarkRaster raster =
    BenchmarkRaster::MakeMountain(options.Quick ? 129 : 1201).Crop(size, size);
  const std::string fileName = GetTerrainFile(options, "part-" + std::to_string(size) + ".tif");
  const vtkSmartPointer<vtkTerrainPyramid> pyramid =
    raster.Write(fileName) ? OpenTerrain(fileName) : nullptr;
  if (pyramid)
  {
    const BenchmarkTerrainError error(raster, pyramid);
    const vtkSmartPointer<vtkImageData> image = MakeHeightImage(raster, error.GetPlacement());
    for (const double meters : { 2.0, 5.0, 10.0, 30.0 })
    {
      vtkNew<vtkTerrainMeshSource> source;
      source->SetPyramid(pyramid);
      source->SetMaximumError(meters);
      vtkNew<vtkGreedyTerrainDecimation> greedy;
      greedy->SetInputData(image);
      greedy->SetErrorMeasureToAbsoluteError();
      greedy->SetAbsoluteError(meters);
      std::vector<double> times[2];
      for (int round = 0; round < (options.Quick ? 1 : 3); ++round)
      {
        const Stopwatch a;
        source->Modified();
        source->Update();
        times[0].push_back(a.GetSeconds());
        const Stopwatch b;
        greedy->Modified();
        greedy->Update();
        times[1].push_back(b.GetSeconds());
      }
      const auto triangles = static_cast<double>(source->GetOutput()->GetNumberOfCells());
      const auto others = static_cast<double>(greedy->GetOutput()->GetNumberOfCells());
      table.AddRow({ meters, triangles, others, triangles / others,
        error.Measure(source->GetOutput()), error.Measure(greedy->GetOutput()), GetMedian(times[0]),
        GetMedian(times[1]), GetMedianRatio(times[0], times[1]) });
    }
  }
  table.AddNote((raster.IsReal() ? "Mount Rainier, " : "A fractal, ") + std::to_string(size) +
    " x " + std::to_string(size) +
    " samples. Errors are the largest distances from the bilinear surface, at 12 points of each "
    "triangle. vtkGreedyTerrainDecimation compares its triangles with the samples only, and not "
    "along the border of the raster. Times are "
    "medians. Asked: 2 for A / B.");
  addTable(table);
}

void AddTerrainCameras(const BenchmarkOptions& options, const AddTable& addTable)
{
  BenchmarkTable table("terrain-cameras", "The error on the screen for random cameras",
    { { "asked", "asked, pixels", 1 }, { "cameras", "cameras", 0 },
      { "largest", "largest error, pixels", 4 }, { "median", "median of the largest, pixels", 3 },
      { "triangles", "triangles, median", 0 }, { "too_large", "cameras above asked + 0.02", 0 },
      { "seconds", "time of a mesh, s, median", 3 } });
  const int viewport[2] = { 1280, 800 };
  const BenchmarkRaster raster = BenchmarkRaster::MakeMountain(options.Quick ? 129 : 1201);
  const std::string fileName =
    GetTerrainFile(options, "mountain-" + std::to_string(raster.GetWidth()) + ".tif");
  const vtkSmartPointer<vtkTerrainPyramid> pyramid =
    WriteTerrainPyramid(raster, fileName) ? OpenTerrain(fileName) : nullptr;
  const int cameras = options.Quick ? 20 : 200;
  for (const double pixels : { 0.5, 1.0, 2.0 })
  {
    if (!pyramid)
    {
      break;
    }
    std::vector<double> errors;
    std::vector<double> triangles;
    std::vector<double> times;
    BenchmarkTerrainError error(raster, pyramid);
    const relevo::TerrainPlacement& placement = error.GetPlacement();
    vtkNew<vtkTerrainMeshSource> source;
    vtkNew<vtkCamera> camera;
    source->SetPyramid(pyramid);
    source->SetCamera(camera);
    source->SetViewportSize(viewport[0], viewport[1]);
    source->SetScreenSpaceError(pixels);
    std::mt19937 random(5);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    const auto getPlace = [&](double above)
    {
      const double column = uniform(random) * (raster.GetWidth() - 1);
      const double row = uniform(random) * (raster.GetHeight() - 1);
      return placement.ToWorld(
        column, row, raster.Interpolate(column, row) + above / placement.HeightScale);
    };
    for (int i = 0; i < cameras; ++i)
    {
      // From 10 m to 30 km above the ground.
      const double above = 10.0 * std::pow(3000.0, uniform(random));
      camera->SetPosition(getPlace(above).data());
      camera->SetFocalPoint(getPlace(0.0).data());
      camera->SetViewUp(0.0, 0.0, 1.0);
      const Stopwatch stopwatch;
      source->Update();
      times.push_back(stopwatch.GetSeconds());
      error.SetCamera(camera, viewport);
      errors.push_back(error.Measure(source->GetOutput()));
      triangles.push_back(static_cast<double>(source->GetOutput()->GetNumberOfCells()));
    }
    table.AddRow({ pixels, static_cast<double>(cameras),
      *std::max_element(errors.begin(), errors.end()), GetMedian(errors), GetMedian(triangles),
      static_cast<double>(std::count_if(errors.begin(), errors.end(),
        [pixels](double measured) { return measured > pixels + 0.02; })),
      GetMedian(times) });
  }
  table.AddNote((raster.IsReal() ? "Mount Rainier, " : "A fractal, ") +
    std::to_string(raster.GetWidth()) + " x " + std::to_string(raster.GetHeight()) +
    " samples, from 10 m to 30 km above the ground, 1280 x 800 pixels. The mesh of "
    "vtkTerrainMeshSource, measured at 12 points of each triangle in double precision.");
  addTable(table);
}
