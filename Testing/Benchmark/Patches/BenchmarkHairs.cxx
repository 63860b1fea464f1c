// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkHairs.h"

#include "BenchmarkFrames.h"
#include "BenchmarkHairScene.h"
#include "BenchmarkPatchMeshes.h"
#include "BenchmarkReport.h"
#include "BenchmarkStaticMapper.h"
#include "BenchmarkView.h"

#include "vtkAdaptiveCurveMapper.h"
#include "vtkAdaptiveRefinement.h"

#include "vtkActor.h"
#include "vtkActorCollection.h"
#include "vtkCamera.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkUnstructuredGrid.h"

#include <numeric>

namespace
{
void AddView(const BenchmarkHairScene& scene, double zoom, const BenchmarkOptions& options,
  BenchmarkTable& table)
{
  BenchmarkView view(options.Quick ? 128 : 1024, options.Quick ? 96 : 768);
  view.LookAt(scene.GetHairs()->GetBounds());
  view.GetRenderer()->GetActiveCamera()->Zoom(zoom);
  const std::vector<int> segments = scene.CountSegments(view);
  const double error = scene.MeasureError(view, segments);
  int even = 0;
  double evenError = 0.0;
  do
  {
    ++even;
    evenError = scene.MeasureError(view, std::vector<int>(segments.size(), even));
  } while (evenError > error);

  vtkNew<vtkAdaptiveCurveMapper> curves;
  curves->SetInputData(scene.GetHairs());
  curves->SetRefinement(BenchmarkPatchMeshes::MakeRecipe(0.5));
  const auto lines = scene.Cut(even);
  vtkNew<BenchmarkStaticMapper> fixed;
  fixed->SetInputData(lines);
  BenchmarkFrames frames(view, std::vector<vtkMapper*>{ curves, fixed });
  vtkActorCollection* actors = view.GetRenderer()->GetActors();
  actors->InitTraversal();
  while (vtkActor* actor = actors->GetNextActor())
  {
    actor->GetProperty()->LightingOff(); // VTK does not light lines without normals
  }
  frames.Measure(options.Quick ? 2 : 15);
  const double buffers = static_cast<double>(curves->GetGraphicsMemorySize());
  const double evenBuffers = fixed->GetGraphicsMemorySize();
  const double memory =
    buffers + 1024.0 * static_cast<double>(scene.GetHairs()->GetActualMemorySize());
  const double evenMemory =
    evenBuffers + 1024.0 * static_cast<double>(lines->GetActualMemorySize());
  const auto hairs = static_cast<double>(segments.size());
  table.AddRow({ zoom, hairs, std::accumulate(segments.begin(), segments.end(), 0) / hairs, error,
    static_cast<double>(even), evenError, frames.GetMedian(0), frames.GetMedian(1),
    frames.GetRatio(0, 1), 1e-6 * buffers, 1e-6 * evenBuffers, buffers / evenBuffers,
    memory / evenMemory });
}
}

void AddHairs(const BenchmarkOptions& options, const AddTable& addTable)
{
  BenchmarkTable table("patches-hairs", "Hair, against lines that are cut evenly",
    { { "zoom", "zoom", 0 }, { "hairs", "hairs", 0 }, { "segments", "segments each", 2 },
      { "error", "off, pixels", 3 }, { "even_segments", "evenly", 0 },
      { "even_error", "off, pixels", 3 }, { "frame_ms", "frame, ms", 1 },
      { "even_frame_ms", "evenly, ms", 1 }, { "ratio_frame", "ratio", 3 },
      { "memory_mb", "buffers, MB", 2 }, { "even_memory_mb", "evenly, MB", 2 },
      { "ratio_memory", "ratio", 3 }, { "ratio_whole", "with data sets", 3 } });
  const BenchmarkHairScene scene(options.Quick ? 200 : 100000);
  for (const double zoom : { 1.0, 10.0 })
  {
    AddView(scene, zoom, options, table);
  }
  table.AddNote(
    "vtkAdaptiveCurveMapper to half a pixel, against vtkPolyDataMapper with the least "
    "number of segments, for all hairs alike, by which those in view are off by no "
    "more. Without lighting, for vtkPolyDataMapper does not light lines that have no "
    "normals. The camera moves with every frame. With data sets: the hairs as cells and "
    "the poly-lines as well. Asked: memory 0.3, frames 1.0, at tenfold zoom 0.3.");
  addTable(table);
}
