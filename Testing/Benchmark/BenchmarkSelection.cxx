// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Tag, select and group in the mapper, with a metric that follows the camera.
#include "BenchmarkMeasure.h"
#include "BenchmarkReport.h"
#include "BenchmarkSurface.h"
#include "BenchmarkView.h"
#include "Benchmarks.h"

#include "vtkAdaptiveRefinement.h"
#include "vtkAdaptiveRefinementMapper.h"
#include "vtkDistanceDepthTagMetric.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

void RunSelection(const BenchmarkOptions& options, const AddTable& addTable)
{
  BenchmarkTable table("selection", "Selection: levels of a moving camera, tag to groups",
    { { "coarse_faces", "coarse", 0 }, { "drawn_triangles", "drawn", 0 },
      { "used_patterns", "patterns", 0 }, { "draw_calls", "draw calls", 0 },
      { "selection_ms", "selection, ms", 3 }, { "selection_ns_per_face", "ns per face", 1 },
      { "frame_ms", "frame, ms", 0 } });
  const std::vector<int> sizes =
    options.Quick ? std::vector<int>{ 200 } : std::vector<int>{ 2000, 20000, 200000 };
  for (const int size : sizes)
  {
    BenchmarkSurface surface(size, 0.0);
    vtkPolyData* mesh = surface.GetMesh();
    mesh->GetPointData()->RemoveArray("DepthTag");
    auto recipe = BenchmarkSurface::MakeLinearRecipe();
    recipe->SetMaximumLevel(5);
    vtkNew<vtkDistanceDepthTagMetric> metric;
    recipe->SetMetric(metric);
    vtkNew<vtkAdaptiveRefinementMapper> mapper;
    mapper->SetInputData(mesh);
    mapper->SetRefinement(recipe);

    BenchmarkView view;
    view.LookAt(mesh->GetBounds());
    view.AddActor(mapper);
    view.TimeFrame();
    std::vector<double> selections;
    std::vector<double> frames;
    for (int round = 0; round < (options.Quick ? 2 : 9); ++round)
    {
      view.MoveCamera();
      frames.push_back(1e3 * view.TimeFrame());
      selections.push_back(1e3 * mapper->GetSelectionTime());
    }
    const auto faces = static_cast<double>(mapper->GetNumberOfCoarseFaces());
    table.AddRow({ faces, static_cast<double>(mapper->GetNumberOfDrawnTriangles()),
      static_cast<double>(mapper->GetNumberOfUsedPatterns()),
      static_cast<double>(mapper->GetNumberOfDrawCalls()), GetMedian(selections),
      1e6 * GetMedian(selections) / faces, GetMedian(frames) });
  }
  table.AddNote("vtkDistanceDepthTagMetric, MaximumLevel 5; every frame selects anew. Medians.");
  addTable(table);
}
