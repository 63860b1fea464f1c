// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Measures what geomorphing costs and what culling saves: frames with and without them, in turn.
#include "BenchmarkMeasure.h"
#include "BenchmarkReport.h"
#include "BenchmarkSurface.h"
#include "BenchmarkView.h"
#include "Benchmarks.h"

#include "vtkActor.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkAdaptiveRefinementMapper.h"
#include "vtkCamera.h"
#include "vtkDistanceDepthTagMetric.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkRenderer.h"
#include "vtkSphereSource.h"

#include <functional>

namespace
{
// One of the two ways to draw a scene.
struct Policy
{
  vtkNew<vtkAdaptiveRefinementMapper> Mapper;
  vtkSmartPointer<vtkActor> Actor;
  std::vector<double> Frames; // seconds
};

struct Comparison
{
  std::string Name;
  vtkSmartPointer<vtkPolyData> Mesh;
  bool IsTerrain;
  // Turns off the feature for the second way.
  std::function<void(vtkAdaptiveRefinementMapper*)> TurnOff;
};

vtkSmartPointer<vtkAdaptiveRefinement> MakeRecipe(int maximumLevel)
{
  auto recipe = BenchmarkSurface::MakePNRecipe();
  recipe->SetMaximumLevel(maximumLevel);
  vtkNew<vtkDistanceDepthTagMetric> metric;
  recipe->SetMetric(metric);
  return recipe;
}

void Compare(const Comparison& comparison, int maximumLevel, int rounds, BenchmarkTable& table)
{
  BenchmarkView view;
  Policy ways[2];
  for (Policy& way : ways)
  {
    way.Mapper->SetInputData(comparison.Mesh);
    way.Mapper->SetRefinement(MakeRecipe(maximumLevel));
    way.Actor = view.AddActor(way.Mapper);
  }
  comparison.TurnOff(ways[1].Mapper);
  view.LookAt(comparison.Mesh->GetBounds());
  if (comparison.IsTerrain)
  {
    view.GetRenderer()->GetActiveCamera()->Zoom(3.0); // so that only part of it is in view
  }
  for (int round = -1; round < rounds; ++round) // the first round is not counted
  {
    view.MoveCamera();
    for (Policy& way : ways)
    {
      ways[0].Actor->SetVisibility(&way == ways);
      ways[1].Actor->SetVisibility(&way != ways);
      const double seconds = view.TimeFrame();
      if (round >= 0)
      {
        way.Frames.push_back(seconds);
      }
    }
  }
  const auto getTriangles = [](Policy& way)
  { return static_cast<double>(way.Mapper->GetNumberOfDrawnTriangles()); };
  table.AddRow({ comparison.Name, static_cast<double>(ways[0].Mapper->GetNumberOfCoarseFaces()),
    static_cast<double>(ways[0].Mapper->GetNumberOfCulledFaces()), getTriangles(ways[0]),
    getTriangles(ways[1]), 1e3 * GetMedian(ways[0].Frames), 1e3 * GetMedian(ways[1].Frames),
    GetMedianRatio(ways[0].Frames, ways[1].Frames) });
}
}

void RunDrawing(const BenchmarkOptions& options, const AddTable& addTable)
{
  BenchmarkTable table("drawing", "Frames with and without geomorphing and culling",
    { { "comparison", "with and without", 0 }, { "coarse_faces", "coarse", 0 },
      { "culled_faces", "culled", 0 }, { "triangles", "triangles", 0 },
      { "triangles_without", "without", 0 }, { "frame_ms", "frame, ms", 0 },
      { "frame_without_ms", "without, ms", 0 }, { "ratio", "ratio", 2 } });
  BenchmarkSurface surface(options.Quick ? 200 : 20000, 0.0);
  vtkPolyData* hills = surface.GetMesh();
  hills->GetPointData()->RemoveArray("DepthTag");
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(options.Quick ? 20 : 100);
  sphere->SetPhiResolution(options.Quick ? 10 : 100);
  sphere->Update();
  const Comparison comparisons[] = {
    { "geomorphing, hills", hills, true,
      [](vtkAdaptiveRefinementMapper* mapper) { mapper->GetRefinement()->GeomorphingOff(); } },
    { "culling, hills", hills, true,
      [](vtkAdaptiveRefinementMapper* mapper) { mapper->FrustumCullingOff(); } },
    { "culling, a closed surface", sphere->GetOutput(), false,
      [](vtkAdaptiveRefinementMapper* mapper) { mapper->FrustumCullingOff(); } },
  };
  for (const Comparison& comparison : comparisons)
  {
    Compare(comparison, options.Quick ? 3 : 5, options.Quick ? 2 : 9, table);
  }
  table.AddNote("PN triangles, vtkDistanceDepthTagMetric; the camera moves before every pair of "
                "frames. Medians.");
  addTable(table);
}
