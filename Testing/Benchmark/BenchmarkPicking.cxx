// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Measures VTK's pickers on the mapper's refined surface, and the locator for a line.
#include "BenchmarkMeasure.h"
#include "BenchmarkReport.h"
#include "BenchmarkSurface.h"
#include "BenchmarkView.h"
#include "Benchmarks.h"

#include "vtkAdaptiveRefinement.h"
#include "vtkAdaptiveRefinementMapper.h"
#include "vtkCamera.h"
#include "vtkCellPicker.h"
#include "vtkDistanceDepthTagMetric.h"
#include "vtkGenericCell.h"
#include "vtkPointData.h"
#include "vtkPointPicker.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkRefinedCellLocator.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <functional>
#include <random>

namespace
{
// Milliseconds of processor time per call. `move` runs before each call and is not timed.
struct Times
{
  Times(
    int count, const std::function<void()>& move, const std::function<void(double, double)>& ask)
  {
    std::mt19937 random(7);
    const auto number = [&random]() { return random() / 4294967296.0; };
    for (int i = 0; i <= count; ++i)
    {
      move();
      const double x = number();
      const double y = number();
      const double start = GetProcessorSeconds();
      ask(x, y);
      const double time = 1e3 * (GetProcessorSeconds() - start);
      if (i == 0)
      {
        this->First = time;
      }
      else
      {
        this->Others.push_back(time);
      }
    }
  }
  double First = 0.0;
  std::vector<double> Others;
};

void AddRow(BenchmarkTable& table, const std::string& what, double faces, double triangles,
  const Times& times)
{
  table.AddRow({ what, faces, triangles, times.First, GetMedian(times.Others),
    *std::max_element(times.Others.begin(), times.Others.end()) });
}

void MeasurePicks(int numberOfFaces, bool quick, BenchmarkTable& table)
{
  BenchmarkSurface surface(numberOfFaces, 0.0);
  vtkPolyData* mesh = surface.GetMesh();
  mesh->GetPointData()->RemoveArray("DepthTag");
  const auto recipe = BenchmarkSurface::MakeDisplacedRecipe();
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
  const auto faces = static_cast<double>(mapper->GetNumberOfCoarseFaces());
  const auto triangles = static_cast<double>(mapper->GetNumberOfDrawnTriangles());
  const int count = quick ? 3 : 100;
  const auto rest = []() {};
  const auto pick = [&](vtkPicker* picker)
  {
    return [&view, picker](double x, double y)
    { picker->Pick(view.GetWidth() * x, view.GetHeight() * y, 0.0, view.GetRenderer()); };
  };
  vtkNew<vtkCellPicker> cells;
  AddRow(table, "vtkCellPicker", faces, triangles, Times(count, rest, pick(cells)));
  AddRow(table, "the same, after a frame each", faces, triangles,
    Times(
      quick ? 1 : 10,
      [&view]()
      {
        view.MoveCamera();
        view.TimeFrame();
      },
      pick(cells)));
  vtkNew<vtkPointPicker> points;
  points->SetTolerance(0.005);
  AddRow(table, "vtkPointPicker", faces, triangles, Times(count, rest, pick(points)));

  vtkNew<vtkRefinedCellLocator> locator;
  locator->SetDataSet(mesh);
  locator->SetRefinement(recipe);
  locator->SetCamera(view.GetRenderer()->GetActiveCamera());
  locator->SetViewportSize(view.GetWidth(), view.GetHeight());
  double bounds[6];
  mapper->GetBounds(bounds);
  vtkNew<vtkGenericCell> cell;
  AddRow(table, "vtkRefinedCellLocator", faces, triangles,
    Times(count, rest,
      [&](double x, double y)
      {
        const double end[3] = { bounds[0] + x * (bounds[1] - bounds[0]),
          bounds[2] + y * (bounds[3] - bounds[2]), bounds[4] };
        double t;
        double place[3];
        double pcoords[3];
        int subId;
        vtkIdType cellId;
        locator->IntersectWithLine(view.GetRenderer()->GetActiveCamera()->GetPosition(), end, 0.0,
          t, place, pcoords, subId, cellId, cell);
      }));

  // The coarse mesh, as VTK picks it.
  vtkNew<vtkPolyDataMapper> flat;
  flat->SetInputData(mesh);
  BenchmarkView flatView;
  flatView.LookAt(mesh->GetBounds());
  flatView.AddActor(flat);
  flatView.TimeFrame();
  AddRow(table, "vtkCellPicker, vtkPolyDataMapper of the coarse mesh", faces, faces,
    Times(quick ? 1 : 20, rest,
      [&](double x, double y) {
        cells->Pick(flatView.GetWidth() * x, flatView.GetHeight() * y, 0.0, flatView.GetRenderer());
      }));
}
}

void RunPicking(const BenchmarkOptions& options, const AddTable& addTable)
{
  BenchmarkTable table("picking", "Picking: PN triangles, displaced, levels by distance",
    { { "picker", "picker", 0 }, { "coarse_faces", "coarse", 0 }, { "triangles", "triangles", 0 },
      { "first_ms", "first, ms of processor", 1 }, { "pick_ms", "each further, ms", 3 },
      { "worst_ms", "slowest, ms", 3 } });
  for (const int size :
    options.Quick ? std::vector<int>{ 200 } : std::vector<int>{ 2000, 20000, 200000 })
  {
    MeasurePicks(size, options.Quick, table);
  }
  addTable(table);
}
