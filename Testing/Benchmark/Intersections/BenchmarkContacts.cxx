// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkContacts.h"

#include "BenchmarkMeasure.h"
#include "BenchmarkMeshes.h"
#include "BenchmarkReport.h"
#include "BenchmarkView.h"

#include "vtkAdaptiveRefinement.h"
#include "vtkAdaptiveRefinementMapper.h"
#include "vtkContactScene.h"
#include "vtkProximityDepthTagMetric.h"

#include "vtkActor.h"
#include "vtkLookupTable.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <cmath>
#include <vector>

namespace
{
constexpr int NumberOfObjects = 8;

// Rings and balls at the corners of a cube. Neighbours intersect.
class Objects
{
public:
  Objects(BenchmarkView& view, int faces, int maximumLevel)
  {
    const int rings = static_cast<int>(std::sqrt(faces / 8.0));
    const vtkSmartPointer<vtkPolyData> meshes[2] = { BenchmarkMeshes::MakeTorus(
                                                       0.75, 0.3, 4 * rings, rings),
      BenchmarkMeshes::MakeSphere(static_cast<double>(faces)) };
    this->Scene->SetDistance(0.5);
    for (int i = 0; i < NumberOfObjects; ++i)
    {
      vtkNew<vtkAdaptiveRefinement> recipe;
      recipe->SetMaximumLevel(maximumLevel);
      vtkNew<vtkAdaptiveRefinementMapper> mapper;
      mapper->SetInputData(meshes[(i ^ (i >> 1) ^ (i >> 2)) & 1]);
      mapper->SetRefinement(recipe);
      this->Mappers.emplace_back(mapper);
      this->Scene->AddActor(view.AddActor(mapper));
    }
    this->Move(0);
    this->Scene->Update();
    for (vtkAdaptiveRefinementMapper* mapper : this->Mappers)
    {
      auto* metric = vtkProximityDepthTagMetric::SafeDownCast(mapper->GetRefinement()->GetMetric());
      mapper->SetColorModeToMetric();
      mapper->SetLevelLookupTable(metric->GetLookupTable());
    }
    const double bounds[6] = { -1.8, 1.8, -1.8, 1.8, -1.8, 1.8 };
    view.LookAt(bounds);
  }

  // Each object rotates about its axis and sways.
  void Move(int frame)
  {
    for (int i = 0; i < NumberOfObjects; ++i)
    {
      vtkActor* actor = this->Scene->GetActor(i);
      double place[3];
      for (int c = 0; c < 3; ++c)
      {
        place[c] = ((i >> c) & 1 ? 0.8 : -0.8) + 0.1 * std::sin(0.2 * frame + i + c);
      }
      actor->SetPosition(place);
      actor->SetOrientation(0.0, 0.0, 0.0);
      actor->RotateWXYZ(3.0 * frame + 45.0 * i, i & 1 ? 1.0 : -1.0, 0.5 * i, 1.0);
    }
  }

  double GetNumberOfTriangles() const
  {
    double triangles = 0.0;
    for (vtkAdaptiveRefinementMapper* mapper : this->Mappers)
    {
      triangles += static_cast<double>(mapper->GetNumberOfDrawnTriangles());
    }
    return triangles;
  }
  vtkContactScene* GetScene() { return this->Scene; }

private:
  vtkNew<vtkContactScene> Scene;
  std::vector<vtkSmartPointer<vtkAdaptiveRefinementMapper>> Mappers;
};

double CountSegments(vtkMultiBlockDataSet* contacts)
{
  double segments = 0.0;
  for (unsigned int i = 0; i < contacts->GetNumberOfBlocks(); ++i)
  {
    auto* curves = vtkPolyData::SafeDownCast(contacts->GetBlock(i));
    segments += static_cast<double>(curves->GetNumberOfLines());
  }
  return segments;
}

double TimeUpdate(vtkContactScene* scene, bool isExact)
{
  scene->SetExactContacts(isExact);
  const Stopwatch watch;
  scene->Update();
  return watch.GetSeconds();
}

void AddScene(const BenchmarkOptions& options, int maximumLevel, BenchmarkTable& table)
{
  BenchmarkView view(options.Quick ? 128 : 1024, options.Quick ? 96 : 768);
  Objects objects(view, options.Quick ? 800 : 20000, maximumLevel);
  vtkContactScene* scene = objects.GetScene();
  for (int frame = 0; frame < 2; ++frame)
  {
    view.TimeFrame(); // warms up
  }
  std::vector<double> frames;
  std::vector<double> candidates;
  std::vector<double> exact;
  for (int frame = 1; frame <= (options.Quick ? 2 : maximumLevel > 4 ? 7 : 30); ++frame)
  {
    objects.Move(frame);
    candidates.push_back(TimeUpdate(scene, false));
    exact.push_back(TimeUpdate(scene, true));
    frames.push_back(view.TimeFrame());
  }
  table.AddRow({ static_cast<double>(maximumLevel), 1e-6 * objects.GetNumberOfTriangles(),
    static_cast<double>(scene->GetNumberOfCandidates()),
    static_cast<double>(scene->GetContacts()->GetNumberOfBlocks()),
    CountSegments(scene->GetContacts()), 1e3 * GetMedian(frames), 1e3 * GetMedian(candidates),
    100.0 * GetMedianRatio(candidates, frames), 1e3 * GetMedian(exact),
    GetMedianRatio(exact, frames) });
}
}

void AddContacts(const BenchmarkOptions& options, const AddTable& addTable)
{
  BenchmarkTable table("intersections-scene", "Eight moving objects in a vtkContactScene",
    { { "maximum_level", "levels up to", 0 }, { "triangles", "triangles drawn, M", 2 },
      { "candidates", "pairs whose boxes meet", 0 }, { "contacts", "that touch", 0 },
      { "segments", "segments", 0 }, { "frame_ms", "frame, ms", 1 },
      { "candidates_ms", "candidates, ms", 3 }, { "candidates_percent", "of the frame, %", 3 },
      { "exact_ms", "exact curves, ms", 1 }, { "ratio_exact", "to the frame", 3 } });
  for (const int maximumLevel : { 5, 2, 0 })
  {
    AddScene(options, maximumLevel, table);
  }
  table.AddNote("Four rings and four balls of about 20 000 triangles each, drawn by "
                "vtkAdaptiveRefinementMapper in the metric's colours, 1024 x 768. All move before "
                "every frame; a frame is from vtkRenderWindow::Render() until OpenGL has finished "
                "it. Candidates: vtkContactScene::Update() without ExactContacts, exact curves: "
                "the same with them. Asked: 2 % and 1, up to level 5, the metric's own; without "
                "refinement the frame is as short as it can be.");
  addTable(table);
}
