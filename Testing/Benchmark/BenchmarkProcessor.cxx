// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Measures single steps on the CPU with Google Benchmark.
#include "BenchmarkMeasure.h"
#include "BenchmarkReport.h"
#include "BenchmarkSurface.h"
#include "Benchmarks.h"

#include "Evaluation/EdgeTags.h"
#include "Evaluation/PatternSelection.h"
#include "Mesh/RefinementMesh.h"
#include "Patterns/RefinementPattern.h"
#include "Recipe/RecipeLevels.h"
#include "View/RefinementView.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkAdaptiveRefinementFilter.h"
#include "vtkPolyData.h"
#include "vtkRefinementPatternTable.h"

#include <benchmark/benchmark.h>

#include <functional>

namespace
{
// Creates all patterns up to the given level in a new table.
void MakePatterns(benchmark::State& state, int level)
{
  int64_t triangles = 0;
  for (auto _ : state)
  {
    vtkNew<vtkRefinementPatternTable> table;
    for (int i = 0; i <= level; ++i)
    {
      for (int j = 0; j <= i; ++j)
      {
        for (int k = 0; k <= j; ++k)
        {
          triangles += table->GetPatternOfSegments(1 << i, 1 << j, 1 << k)->GetNumberOfTriangles();
        }
      }
    }
  }
  state.SetItemsProcessed(triangles);
}

// From depth-tags to groups of faces.
void Select(benchmark::State& state, BenchmarkSurface& surface)
{
  auto recipe = BenchmarkSurface::MakeLinearRecipe();
  relevo::RefinementMesh mesh;
  mesh.Build(surface.GetMesh(), recipe->GetSurface(), recipe->GetDisplacement());
  relevo::EdgeTags tags;
  std::string error;
  tags.Compute(recipe, surface.GetMesh(), mesh, {}, error);
  const auto family = relevo::GetPatternFamily(recipe, surface.GetMesh());
  relevo::PatternSelection selection;
  for (auto _ : state)
  {
    selection.Select(mesh, tags, *family, recipe->GetMaximumLevel());
    selection.Group();
    benchmark::DoNotOptimize(selection.Instances.data());
  }
  state.SetItemsProcessed(
    static_cast<int64_t>(state.iterations()) * static_cast<int64_t>(mesh.Faces.size()));
}

// From tags to the refined vtkPolyData.
void Refine(benchmark::State& state, BenchmarkSurface& surface, vtkAdaptiveRefinement* recipe)
{
  vtkNew<vtkAdaptiveRefinementFilter> filter;
  filter->SetInputData(surface.GetMesh());
  filter->SetRefinement(recipe);
  filter->Update(); // creates the patterns
  for (auto _ : state)
  {
    filter->Modified();
    filter->Update();
  }
  state.SetItemsProcessed(
    static_cast<int64_t>(state.iterations()) * filter->GetOutput()->GetNumberOfPolys());
}

std::string GetName(BenchmarkSurface& surface)
{
  return std::to_string(surface.GetMesh()->GetNumberOfPolys()) + " faces";
}

/// Reports runs as rows of a table.
class Reporter : public benchmark::BenchmarkReporter
{
public:
  explicit Reporter(BenchmarkTable& table)
    : Table(table)
  {
  }

  bool ReportContext(const Context&) override { return true; }

  void ReportRuns(const std::vector<Run>& runs) override
  {
    for (const Run& run : runs)
    {
      const auto rate = run.counters.find("items_per_second");
      const double seconds = run.real_accumulated_time / static_cast<double>(run.iterations);
      this->Table.AddRow({ run.run_name.function_name, 1e3 * seconds,
        rate == run.counters.end() ? 0.0 : 1e9 / rate->second.value });
    }
  }

private:
  BenchmarkTable& Table;
};
}

void RunProcessor(const BenchmarkOptions& options, const AddTable& addTable)
{
  BenchmarkTable table("processor", "The CPU's own work",
    { { "work", "work", 0 }, { "time_ms", "ms", 2 }, { "ns_per_item", "ns per item", 1 } });

  const double triangles = options.Quick ? 5e3 : 1e6;
  BenchmarkSurface coarse(options.Quick ? 200 : 2000, triangles);
  BenchmarkSurface fine(options.Quick ? 2000 : 200000, triangles);
  auto add = [](const std::string& work, const std::function<void(benchmark::State&)>& run) {
    benchmark::RegisterBenchmark(work.c_str(), run)->Unit(benchmark::kMillisecond)->UseRealTime();
  };
  for (const int level : options.Quick ? std::vector<int>{ 2 } : std::vector<int>{ 5, 7 })
  {
    add("all patterns to level " + std::to_string(level) + ", per triangle",
      [level](benchmark::State& state) { MakePatterns(state, level); });
  }
  add("select and group, " + GetName(fine) + ", per face",
    [&](benchmark::State& state) { Select(state, fine); });
  add("filter, linear, " + GetName(coarse) + ", per triangle",
    [&](benchmark::State& state) { Refine(state, coarse, BenchmarkSurface::MakeLinearRecipe()); });
  add("filter, PN, " + GetName(coarse) + ", per triangle",
    [&](benchmark::State& state) { Refine(state, coarse, BenchmarkSurface::MakePNRecipe()); });
  add("filter, PN + displacement, " + GetName(coarse) + ", per triangle",
    [&](benchmark::State& state)
    { Refine(state, coarse, BenchmarkSurface::MakeDisplacedRecipe()); });
  add("filter, linear, " + GetName(fine) + ", per triangle",
    [&](benchmark::State& state) { Refine(state, fine, BenchmarkSurface::MakeLinearRecipe()); });

  std::string name = "relevo-benchmark";
  std::string minimumTime =
    options.Quick ? "--benchmark_min_time=0.001" : "--benchmark_min_time=0.3";
  char* arguments[] = { &name[0], &minimumTime[0], nullptr };
  int count = 2;
  benchmark::Initialize(&count, arguments);
  Reporter reporter(table);
  benchmark::RunSpecifiedBenchmarks(&reporter);
  benchmark::ClearRegisteredBenchmarks();
  table.AddNote("Wall clock, all cores. Filter: about " +
    std::to_string(static_cast<int>(triangles)) + " triangles out.");
  addTable(table);
}
