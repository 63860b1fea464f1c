// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Measures a flight over hills with a triangle budget: how closely the budget is kept, how the
// levels change, and what finding the offset costs. Nothing is drawn.
#include "BenchmarkMeasure.h"
#include "BenchmarkReport.h"
#include "BenchmarkSurface.h"
#include "Benchmarks.h"

#include "Evaluation/EdgeTags.h"
#include "Evaluation/PatternSelection.h"
#include "Evaluation/TriangleBudget.h"
#include "Mesh/RefinementMesh.h"
#include "Recipe/RecipeLevels.h"
#include "View/RefinementView.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkCamera.h"
#include "vtkDistanceDepthTagMetric.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkScreenEdgeDepthTagMetric.h"

#include <algorithm>
#include <cmath>

namespace
{
// Flies over the hills of BenchmarkSurface, swaying, from time 0 to 1.
void Fly(vtkCamera* camera, double time)
{
  const double x = 0.5 + 2.5 * time;
  const double y = 1.5 + 0.7 * std::sin(5.0 * time);
  camera->SetPosition(x, y, 1.2 + 0.3 * std::cos(7.0 * time));
  camera->SetFocalPoint(x + 0.8, y + 0.4 * std::sin(11.0 * time), 0.0);
  camera->SetViewUp(0.0, 0.0, 1.0);
  camera->SetClippingRange(0.01, 10.0);
}

struct FlightResult
{
  double Deviation = 0.0;                // the largest, as a share of the target
  double Step = 0.0;                     // largest change of the offset, in levels
  std::vector<double> Tag, Find, Select; // seconds
};

FlightResult FlyWithBudget(
  vtkPolyData* mesh, vtkAdaptiveRefinement* recipe, vtkIdType target, int numberOfFrames)
{
  relevo::RefinementMesh faces;
  faces.Build(mesh, recipe->GetSurface(), recipe->GetDisplacement());
  vtkNew<vtkCamera> camera;
  relevo::RefinementView view;
  view.Camera = camera;
  view.ViewportSize[0] = 1024;
  view.ViewportSize[1] = 768;
  const auto family = relevo::GetPatternFamily(recipe, mesh);
  relevo::EdgeTags tags;
  relevo::PatternSelection selection;
  relevo::TriangleBudget budget;
  FlightResult result;
  double last = 0.0;
  for (int frame = 0; frame < numberOfFrames; ++frame)
  {
    Fly(camera, static_cast<double>(frame) / numberOfFrames);
    std::string error;
    const Stopwatch tagging;
    tags.Compute(recipe, mesh, faces, view, relevo::GetHighestTag(recipe, true), error);
    result.Tag.push_back(tagging.GetSeconds());
    const Stopwatch finding;
    const double offset = budget.FindOffset(
      { { &faces, &tags, family } }, recipe->GetMaximumLevel(), target, -16.0, 16.0, last);
    result.Find.push_back(finding.GetSeconds());
    const Stopwatch selecting;
    selection.Select(faces, tags, *family, recipe->GetMaximumLevel(), static_cast<float>(offset));
    selection.Group();
    result.Select.push_back(selecting.GetSeconds());
    const auto count = static_cast<double>(selection.GetNumberOfTriangles());
    result.Deviation =
      std::max(result.Deviation, std::abs(count / static_cast<double>(target) - 1.0));
    result.Step = frame > 0 ? std::max(result.Step, std::abs(offset - last)) : 0.0;
    last = offset;
  }
  return result;
}
}

void RunFlight(const BenchmarkOptions& options, const AddTable& addTable)
{
  const int numberOfFaces = options.Quick ? 2000 : 20000;
  const vtkIdType target = options.Quick ? 20000 : 1000000;
  const int numberOfFrames = options.Quick ? 10 : 200;
  BenchmarkTable table("flight", "A budget of triangles over a flight",
    { { "levels", "levels", 0 }, { "coarse_faces", "coarse", 0 }, { "target", "target", 0 },
      { "deviation_percent", "largest deviation, %", 2 },
      { "offset_step", "largest step of the offset, levels", 3 },
      { "tag_ns_per_face", "tag, ns per face", 1 }, { "find_ns_per_face", "find the offset", 1 },
      { "select_ns_per_face", "select and group", 1 } });
  BenchmarkSurface surface(numberOfFaces, 0.0);
  vtkPolyData* mesh = surface.GetMesh();
  mesh->GetPointData()->RemoveArray("DepthTag");
  struct Policy
  {
    const char* Name;
    bool Distance;
    int Rule;
    int Policy;
    int Measure;
  };
  for (const Policy& way : { Policy{ "distance, per vertex", true, 0, 0, 0 },
         Policy{ "screen edge, per vertex", false, 0, 0, 0 },
         Policy{ "screen edge, per edge", false, 1, 0, 0 },
         Policy{ "screen edge, whole numbers", false, 0, 1, 0 },
         Policy{ "sphere of the edge, per vertex", false, 0, 0, 1 },
         Policy{ "sphere of the edge, per edge", false, 1, 0, 1 } })
  {
    auto recipe = BenchmarkSurface::MakeLinearRecipe();
    recipe->SetMaximumLevel(6);
    recipe->SetLevelRule(way.Rule);
    recipe->SetSegmentPolicy(way.Policy);
    vtkNew<vtkDistanceDepthTagMetric> distance;
    vtkNew<vtkScreenEdgeDepthTagMetric> edges;
    edges->SetReferenceLength(2.0);
    edges->SetMeasure(way.Measure);
    recipe->SetMetric(way.Distance ? static_cast<vtkDepthTagMetric*>(distance) : edges);
    const FlightResult result = FlyWithBudget(mesh, recipe, target, numberOfFrames);
    const double scale = 1e9 / static_cast<double>(mesh->GetNumberOfPolys());
    table.AddRow({ std::string(way.Name), static_cast<double>(mesh->GetNumberOfPolys()),
      static_cast<double>(target), 100.0 * result.Deviation, result.Step,
      scale * GetMedian(result.Tag), scale * GetMedian(result.Find),
      scale * GetMedian(result.Select) });
  }
  table.AddNote(std::to_string(numberOfFrames) +
    " frames at 1024 x 768; vtkDistanceDepthTagMetric, or vtkScreenEdgeDepthTagMetric with 2 "
    "pixels; MaximumLevel 6. Edges beside and behind the eye, as good as endless on the screen, "
    "take most of a budget by screen edges, and change together. Times are medians over the "
    "frames, with all cores.");
  addTable(table);
}
