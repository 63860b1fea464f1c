// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Measures tagging, selection and grouping in the mapper, with a view-dependent metric.
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
#include "vtkScreenEdgeDepthTagMetric.h"
#include "vtkSilhouetteDepthTagMetric.h"
#include "vtkViewDependentDepthTagMetric.h"

namespace
{
struct Levels
{
  std::string Name;
  vtkSmartPointer<vtkDepthTagMetric> Metric;
  int Rule;
};

void MeasureSelection(int numberOfFaces, const Levels& levels, bool quick, BenchmarkTable& table)
{
  BenchmarkSurface surface(numberOfFaces, 0.0);
  vtkPolyData* mesh = surface.GetMesh();
  mesh->GetPointData()->RemoveArray("DepthTag");
  auto recipe = BenchmarkSurface::MakeLinearRecipe();
  recipe->SetMaximumLevel(5);
  recipe->SetMetric(levels.Metric);
  recipe->SetLevelRule(levels.Rule);
  vtkNew<vtkAdaptiveRefinementMapper> mapper;
  mapper->SetInputData(mesh);
  mapper->SetRefinement(recipe);
  mapper->SetSelectionDeviceToCPU();

  BenchmarkView view;
  view.LookAt(mesh->GetBounds());
  view.AddActor(mapper);
  view.TimeFrame();
  std::vector<double> selections;
  std::vector<double> frames;
  for (int round = 0; round < (quick ? 2 : 9); ++round)
  {
    view.MoveCamera();
    frames.push_back(1e3 * view.TimeFrame());
    selections.push_back(1e3 * mapper->GetSelectionTime());
  }
  const vtkIdType before = mapper->GetNumberOfSelections();
  view.TimeFrame();
  view.TimeFrame();
  const auto faces = static_cast<double>(mapper->GetNumberOfCoarseFaces());
  table.AddRow({ levels.Name, faces, static_cast<double>(mapper->GetNumberOfDrawnTriangles()),
    static_cast<double>(mapper->GetNumberOfUsedPatterns()),
    static_cast<double>(mapper->GetNumberOfDrawCalls()), GetMedian(selections),
    1e6 * GetMedian(selections) / faces, GetMedian(frames),
    100.0 * GetMedianRatio(selections, frames),
    static_cast<double>(mapper->GetNumberOfSelections() - before) });
}
}

void RunSelection(const BenchmarkOptions& options, const AddTable& addTable)
{
  BenchmarkTable table("selection", "Selection: levels of a moving camera, tag to groups",
    { { "metric", "levels by", 0 }, { "coarse_faces", "coarse", 0 },
      { "drawn_triangles", "drawn", 0 }, { "used_patterns", "patterns", 0 },
      { "draw_calls", "draw calls", 0 }, { "selection_ms", "selection, ms", 3 },
      { "selection_ns_per_face", "ns per face", 1 }, { "frame_ms", "frame, ms", 0 },
      { "share_percent", "of the frame, %", 1 },
      { "unchanged_selections", "selections, camera at rest", 0 } });
  vtkNew<vtkDistanceDepthTagMetric> distance;
  vtkNew<vtkScreenEdgeDepthTagMetric> edges;
  vtkNew<vtkSilhouetteDepthTagMetric> silhouette;
  vtkNew<vtkViewDependentDepthTagMetric> view;
  const Levels ways[] = { { "distance", distance.Get(), 0 },
    { "screen edge, per vertex", edges.Get(), 0 }, { "screen edge, per edge", edges.Get(), 1 },
    { "silhouette", silhouette.Get(), 0 }, { "view-dependent", view.Get(), 0 } };
  const std::vector<int> sizes =
    options.Quick ? std::vector<int>{ 200 } : std::vector<int>{ 2000, 20000, 200000 };
  for (const Levels& levels : ways)
  {
    for (const int size : sizes)
    {
      MeasureSelection(size, levels, options.Quick, table);
    }
  }
  table.AddNote(
    "On the CPU with all cores, MaximumLevel 5; every frame selects anew, but those of a "
    "camera at rest. Medians.");
  addTable(table);
}
