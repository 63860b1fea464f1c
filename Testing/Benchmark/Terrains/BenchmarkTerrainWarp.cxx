// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkTerrainWarp.h"

#include "BenchmarkMeasure.h"
#include "BenchmarkRaster.h"
#include "BenchmarkReport.h"
#include "BenchmarkTerrainFiles.h"
#include "BenchmarkView.h"
#include "Mathematics/PictureSimilarity.h"
#include "vtkTerrainMapper.h"
#include "vtkTerrainPyramid.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkImageDataGeometryFilter.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkPolyDataNormals.h"
#include "vtkRenderer.h"
#include "vtkTIFFReader.h"
#include "vtkWarpScalar.h"

#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <system_error>

namespace
{
constexpr double SampleSpacing = 30.0;

// The last row of the file comes first.
constexpr unsigned int OrientationBottomLeft = 4;

constexpr int Width = 1280;
constexpr int Height = 800;
// Per pixel and direction, of the picture without aliasing.
constexpr int FineSamples = 4;

using Picture = std::vector<unsigned char>;

// The means of squares of pixels.
Picture Shrink(const Picture& fine)
{
  Picture picture(static_cast<std::size_t>(3) * Width * Height);
  for (std::size_t i = 0; i < picture.size(); ++i)
  {
    const std::size_t x = i / 3 % Width;
    const std::size_t y = i / 3 / Width;
    int sum = 0;
    for (std::size_t k = 0; k < FineSamples * FineSamples; ++k)
    {
      const std::size_t row = y * FineSamples + k / FineSamples;
      const std::size_t column = x * FineSamples + k % FineSamples;
      sum += fine[3 * (row * Width * FineSamples + column) + i % 3];
    }
    picture[i] = static_cast<unsigned char>(
      (sum + FineSamples * FineSamples / 2) / (FineSamples * FineSamples));
  }
  return picture;
}

Picture ReadPicture(const std::string& fileName)
{
  std::ifstream stream(fileName, std::ios::binary);
  Picture bytes((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
  stream.close();
  std::error_code error;
  std::filesystem::remove(fileName, error);
  return bytes;
}

struct WarpWay
{
  vtkSmartPointer<vtkMapper> Mapper;
  vtkSmartPointer<vtkActor> Actor;
  vtkSmartPointer<vtkPolyDataNormals> Normals;
};

// In the frame of vtkTerrainMapper: meters from the center.
WarpWay MakeWarp(BenchmarkView& view, const std::string& fileName)
{
  vtkNew<vtkTIFFReader> reader;
  reader->SetFileName(fileName.c_str());
  reader->SetDataSpacing(SampleSpacing, SampleSpacing, 1.0);
  reader->SetSpacingSpecifiedFlag(true);
  reader->SetOrientationType(OrientationBottomLeft);
  vtkNew<vtkImageDataGeometryFilter> geometry;
  geometry->SetInputConnection(reader->GetOutputPort());
  vtkNew<vtkWarpScalar> warp;
  warp->SetInputConnection(geometry->GetOutputPort());
  WarpWay way;
  way.Normals = vtkSmartPointer<vtkPolyDataNormals>::New();
  way.Normals->SetInputConnection(warp->GetOutputPort());
  way.Normals->SplittingOff();
  auto mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
  mapper->SetInputConnection(way.Normals->GetOutputPort());
  mapper->ScalarVisibilityOff();
  way.Mapper = mapper;
  way.Actor = view.AddActor(mapper);
  const double* bounds = mapper->GetBounds();
  way.Actor->SetPosition(-0.5 * (bounds[0] + bounds[1]), -0.5 * (bounds[2] + bounds[3]), 0.0);
  return way;
}

WarpWay MakeTerrain(BenchmarkView& view, const std::string& fileName, double pixels)
{
  vtkNew<vtkTerrainPyramid> pyramid;
  pyramid->SetFileName(fileName.c_str());
  auto mapper = vtkSmartPointer<vtkTerrainMapper>::New();
  mapper->SetPyramid(pyramid);
  mapper->SetLoadingModeToComplete();
  mapper->SetScreenSpaceError(pixels);
  WarpWay way;
  way.Mapper = mapper;
  way.Actor = view.AddActor(mapper);
  return way;
}
}

std::vector<double> MeasureTerrainWarp(const std::vector<std::string>& arguments)
{
  const bool isFine = arguments.at(0) == "fine";
  const bool isVTK = arguments.at(0) == "vtk" || isFine;
  const int samples = isFine ? FineSamples : 1;
  BenchmarkView view(samples * Width, samples * Height);
  const double before = GetResidentMemory().Current;
  const Stopwatch stopwatch;
  const WarpWay way = isVTK ? MakeWarp(view, arguments.at(1))
                            : MakeTerrain(view, arguments.at(1), std::stod(arguments.at(0)));
  vtkCamera* camera = view.GetRenderer()->GetActiveCamera();
  const double half = 0.5 * std::stod(arguments.at(3)) * SampleSpacing;
  camera->SetPosition(0.0, -0.9 * half, 2000.0 + 0.3 * half);
  camera->SetFocalPoint(0.0, 0.0, 2000.0);
  camera->SetViewUp(0.0, 0.0, 1.0);
  view.TimeFrame();
  const double first = stopwatch.GetSeconds();
  const Picture picture = isFine ? Shrink(view.GetPicture()) : view.GetPicture();
  std::ofstream(arguments.at(2), std::ios::binary)
    .write(
      reinterpret_cast<const char*>(picture.data()), static_cast<std::streamsize>(picture.size()));
  std::vector<double> frames;
  for (int frame = 0; frame < (isFine ? 1 : 15); ++frame)
  {
    view.MoveCamera();
    frames.push_back(view.TimeFrame());
  }
  const double grown = GetResidentMemory().Peak - before;
  auto* terrain = vtkTerrainMapper::SafeDownCast(way.Mapper);
  const vtkIdType triangles =
    terrain ? terrain->GetNumberOfDrawnTriangles() : way.Normals->GetOutput()->GetNumberOfCells();
  return { first, GetMedian(frames), grown, static_cast<double>(triangles) };
}

void AddTerrainWarp(const BenchmarkOptions& options, const AddTable& addTable)
{
  BenchmarkTable table("terrain-warp",
    "From the file to the picture: vtkTerrainMapper (A) against reader, "
    "vtkImageDataGeometryFilter, vtkWarpScalar and vtkPolyDataNormals (B)",
    { { "asked", "error of A, pixels", 2 }, { "ssim", "SSIM", 4 },
      { "ssim_fine_a", "A against B with 16 samples per pixel", 4 },
      { "ssim_fine_b", "B against it", 4 }, { "first_a_s", "first picture of A, s", 2 },
      { "first_b_s", "of B, s", 2 }, { "first", "B / A", 1 }, { "frame_a_ms", "frame of A, ms", 1 },
      { "frame_b_ms", "of B, ms", 1 }, { "frames", "B / A", 1 },
      { "memory_a_mb", "memory of A, MB", 0 }, { "memory_b_mb", "of B, MB", 0 },
      { "memory", "B / A", 1 }, { "triangles_a", "triangles of A", 0 },
      { "triangles_b", "of B", 0 } });
  const int size = options.Quick ? 128 : 4096;
  const std::string plain = GetTerrainFile(options, "plain-" + std::to_string(size) + ".tif");
  const std::string file = GetTerrainFile(options, "fractal-" + std::to_string(size) + ".tif");
  if (!BenchmarkRaster::MakeFractal(size).Write(plain) || !WriteFractal(file, size) ||
    !OpenTerrain(file))
  {
    table.AddNote("No file can be written to " + plain + ".");
    addTable(table);
    return;
  }
  const std::string pictures[2] = { GetTerrainFile(options, "a.rgb"),
    GetTerrainFile(options, "b.rgb") };
  const std::string side = std::to_string(size);
  const std::string finePicture = GetTerrainFile(options, "fine.rgb");
  RunInOwnProcess({ "terrain", "warp", "fine", plain, finePicture, side });
  const Picture fine = ReadPicture(finePicture);
  for (const char* pixels : { "1", "0.5", "0.25" })
  {
    // A B A B
    std::vector<double> figures[2][4];
    for (int round = 0; round < (options.Quick ? 1 : 2); ++round)
    {
      for (int way = 0; way < 2; ++way)
      {
        std::cerr << "terrain: first picture of " << (way == 0 ? "A" : "B") << std::endl;
        const auto result = RunInOwnProcess({ "terrain", "warp", way == 0 ? pixels : "vtk",
          way == 0 ? file : plain, pictures[way], side });
        for (size_t i = 0; i < 4 && result.size() == 4; ++i)
        {
          figures[way][i].push_back(result[i]);
        }
      }
    }
    const Picture bytes[2] = { ReadPicture(pictures[0]), ReadPicture(pictures[1]) };
    if (figures[0][0].empty() || figures[1][0].empty() || bytes[0].size() != bytes[1].size() ||
      fine.size() != bytes[0].size())
    {
      continue;
    }
    const auto median = [&figures](int way, int figure) { return GetMedian(figures[way][figure]); };
    table.AddRow(
      { std::stod(pixels), relevo::GetPictureSimilarity(bytes[0], bytes[1], Width, Height),
        relevo::GetPictureSimilarity(bytes[0], fine, Width, Height),
        relevo::GetPictureSimilarity(bytes[1], fine, Width, Height), median(0, 0), median(1, 0),
        GetMedianRatio(figures[1][0], figures[0][0]), 1e3 * median(0, 1), 1e3 * median(1, 1),
        GetMedianRatio(figures[1][1], figures[0][1]), 1e-6 * median(0, 2), 1e-6 * median(1, 2),
        GetMedianRatio(figures[1][2], figures[0][2]), median(0, 3), median(1, 3) });
  }
  table.AddNote("A fractal, " + side + " x " + side +
    " samples of int16, 1280 x 800 pixels. A opens a pyramid with its index, B an uncompressed "
    "TIFF. Memory is growth at its peak over a process with an empty window. B aliases where "
    "pixels cover several samples; its picture with 16 samples per pixel does not. Asked: 60, 5 "
    "and 30 for B / A at an SSIM of 0.99.");
  addTable(table);
}
