// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Compares frames of the mapper with the same triangles as a static mesh in VTK's mapper. Both are
// drawn in turn in one window from the same positions. Ratios compare frames of the same turn, so
// that the load of other programs cancels.
#include "BenchmarkFrames.h"
#include "BenchmarkMeasure.h"
#include "BenchmarkReport.h"
#include "BenchmarkStaticMapper.h"
#include "BenchmarkSurface.h"
#include "BenchmarkView.h"
#include "Benchmarks.h"

#include "vtkAdaptiveRefinement.h"
#include "vtkAdaptiveRefinementMapper.h"
#include "vtkPolyData.h"

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <limits>

namespace
{
struct Size
{
  int Faces;
  double Triangles;
  int Rounds;
};

vtkSmartPointer<BenchmarkStaticMapper> MakeStaticMapper(vtkPolyData* refined)
{
  auto mapper = vtkSmartPointer<BenchmarkStaticMapper>::New();
  mapper->SetInputData(refined);
  return mapper;
}

vtkSmartPointer<vtkAdaptiveRefinementMapper> MakeMapper(
  vtkPolyData* mesh, vtkAdaptiveRefinement* recipe)
{
  auto mapper = vtkSmartPointer<vtkAdaptiveRefinementMapper>::New();
  mapper->SetInputData(mesh);
  mapper->SetRefinement(recipe);
  return mapper;
}

/// Seconds until a mapper's first picture in a separate window. The input is up to date.
double TimeFirstFrame(vtkMapper* mapper, const double bounds[6])
{
  BenchmarkView view;
  view.LookAt(bounds);
  view.AddActor(mapper);
  return view.TimeFrame();
}

double GetMeanDifference(
  const std::vector<unsigned char>& picture, const std::vector<unsigned char>& reference)
{
  double sum = 0.0;
  for (size_t i = 0; i < picture.size(); ++i)
  {
    sum += std::abs(static_cast<int>(picture[i]) - static_cast<int>(reference[i]));
  }
  return picture.empty() ? 0.0 : sum / static_cast<double>(picture.size());
}

BenchmarkTable MakeFramesTable()
{
  return BenchmarkTable("static-mesh-frames",
    "Frames: Relevo's mapper (B) against the same triangles as a static mesh (A)",
    { { "coarse_faces", "coarse", 0 }, { "drawn_triangles", "drawn", 0 },
      { "used_patterns", "patterns", 0 }, { "draw_calls", "draw calls", 0 },
      { "frame_a_ms", "A, ms", 0 }, { "frame_b_ms", "B, ms", 0 }, { "frame_ratio", "B / A", 2 },
      { "frame_pn_ms", "B with PN, ms", 0 }, { "frame_pn_ratio", "PN / A", 2 },
      { "frame_displaced_ms", "PN + displacement, ms", 0 },
      { "frame_displaced_ratio", "displaced / A", 2 },
      { "picture_difference", "A - B, of 255", 3 } });
}

BenchmarkTable MakeStartTable()
{
  return BenchmarkTable("static-mesh-memory", "First frame and graphics memory",
    { { "coarse_faces", "coarse", 0 }, { "drawn_triangles", "drawn", 0 },
      { "first_a_ms", "first A, ms", 0 }, { "first_b_ms", "first B, ms", 0 },
      { "first_ratio", "B / A", 2 }, { "mesh_ms", "A's mesh, ms", 0 },
      { "first_whole_ratio", "B / (mesh + A)", 2 }, { "memory_a_mb", "memory A, MB", 1 },
      { "memory_b_mb", "memory B, MB", 2 }, { "memory_percent", "B / A, %", 2 },
      { "memory_pn_mb", "PN, MB", 2 }, { "memory_displaced_mb", "PN + displacement, MB", 2 } });
}

/// Milliseconds of rounds, measured in turn like frames. New mappers and recipes are used, so that
/// patterns are created again.
struct FirstFrames
{
  FirstFrames(BenchmarkSurface& surface, const double bounds[6], int rounds)
  {
    for (int round = 0; round < rounds; ++round)
    {
      const Stopwatch watch;
      auto refined = surface.MakeRefinedMesh();
      this->Making.push_back(1e3 * watch.GetSeconds());
      this->Fixed.push_back(1e3 * TimeFirstFrame(MakeStaticMapper(refined), bounds));
      this->Whole.push_back(this->Making.back() + this->Fixed.back());
      this->Ours.push_back(1e3 *
        TimeFirstFrame(
          MakeMapper(surface.GetMesh(), BenchmarkSurface::MakeLinearRecipe()), bounds));
    }
  }
  std::vector<double> Making; // creating A's mesh
  std::vector<double> Fixed;  // A
  std::vector<double> Whole;  // both
  std::vector<double> Ours;   // B
};

void MeasureSize(
  const Size& size, bool quick, BenchmarkTable& framesTable, BenchmarkTable& startTable)
{
  BenchmarkSurface surface(size.Faces, size.Triangles);
  vtkPolyData* mesh = surface.GetMesh();
  auto refined = surface.MakeRefinedMesh();
  double bounds[6];
  refined->GetBounds(bounds);
  const FirstFrames first(surface, bounds, quick ? 1 : 3);

  auto fixed = MakeStaticMapper(refined);
  auto linear = MakeMapper(mesh, BenchmarkSurface::MakeLinearRecipe());
  auto curved = MakeMapper(mesh, BenchmarkSurface::MakePNRecipe());
  auto displaced = MakeMapper(mesh, BenchmarkSurface::MakeDisplacedRecipe());
  BenchmarkView view;
  view.LookAt(bounds);
  std::vector<unsigned char> picture;
  double difference = 0.0;
  BenchmarkFrames times(view, { fixed, linear, curved, displaced },
    [&](size_t mapper)
    {
      if (mapper == 0)
      {
        picture = view.GetPicture();
      }
      else if (mapper == 1)
      {
        difference = GetMeanDifference(view.GetPicture(), picture);
      }
    });
  times.Measure(size.Rounds);

  const double faces = static_cast<double>(linear->GetNumberOfCoarseFaces());
  const double triangles = static_cast<double>(refined->GetNumberOfPolys());
  framesTable.AddRow({ faces, triangles, static_cast<double>(linear->GetNumberOfUsedPatterns()),
    static_cast<double>(linear->GetNumberOfDrawCalls()), times.GetMedian(0), times.GetMedian(1),
    times.GetRatio(1, 0), times.GetMedian(2), times.GetRatio(2, 0), times.GetMedian(3),
    times.GetRatio(3, 0), difference });
  const double memory[] = { fixed->GetGraphicsMemorySize(),
    static_cast<double>(linear->GetGraphicsMemorySize()),
    static_cast<double>(curved->GetGraphicsMemorySize()),
    static_cast<double>(displaced->GetGraphicsMemorySize()) };
  startTable.AddRow({ faces, triangles, GetMedian(first.Fixed), GetMedian(first.Ours),
    GetMedianRatio(first.Ours, first.Fixed), GetMedian(first.Making),
    GetMedianRatio(first.Ours, first.Whole), 1e-6 * memory[0], 1e-6 * memory[1],
    100.0 * memory[1] / memory[0], 1e-6 * memory[2], 1e-6 * memory[3] });
}
}

void RunStaticMesh(const BenchmarkOptions& options, const AddTable& addTable)
{
  std::vector<Size> sizes = { { 2000, 0.5e6, 15 }, { 2000, 2e6, 11 }, { 2000, 8e6, 7 },
    { 20000, 0.5e6, 15 }, { 20000, 2e6, 11 }, { 20000, 8e6, 7 }, { 200000, 0.5e6, 15 },
    { 200000, 2e6, 11 }, { 200000, 8e6, 7 } };
  if (options.Quick)
  {
    sizes = { { 200, 5e3, 3 } };
  }
  BenchmarkTable frames = MakeFramesTable();
  BenchmarkTable start = MakeStartTable();
  for (const Size& size : sizes)
  {
    std::cerr << "static-mesh: " << size.Faces << " -> " << size.Triangles << std::endl;
    MeasureSize(size, options.Quick, frames, start);
  }
  frames.AddNote(
    "1024 x 768, the camera moves, wall clock to glFinish. Medians; ratios are medians "
    "over pairs of frames drawn one after the other from the same place.");
  addTable(frames);
  start.AddNote(
    "First frame: a new mapper and a new recipe in a fresh window, the coarse "
    "mesh ready, and for A the refined one, which vtkAdaptiveRefinementFilter makes in "
    "the time beside. Memory: vertex and index buffers of A; B as GetGraphicsMemorySize() says.");
  addTable(start);
}
