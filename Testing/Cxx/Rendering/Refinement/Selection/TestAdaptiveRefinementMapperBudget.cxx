// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves guide.md on budgets: the mapper keeps the number of triangles near the target, and the
// frame time near the time that VTK allots.
#include "RelevoCheck.h"

#include "vtkActor.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkAdaptiveRefinementFilter.h"
#include "vtkAdaptiveRefinementMapper.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkHardwareSelector.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkScreenEdgeDepthTagMetric.h"
#include "vtkSelection.h"
#include "vtkSphereSource.h"

#include <cmath>
#include <string>

namespace
{
// Hills, so that edges have different lengths on the screen.
vtkSmartPointer<vtkPolyData> MakeHills(int resolution)
{
  vtkNew<vtkPlaneSource> source;
  source->SetResolution(resolution, resolution);
  source->Update();
  vtkPolyData* mesh = source->GetOutput();
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double p[3];
    mesh->GetPoint(i, p);
    p[2] = 0.05 * std::sin(17.0 * p[0]) * std::cos(13.0 * p[1]) + 0.02 * std::sin(41.0 * p[1]);
    mesh->GetPoints()->SetPoint(i, p);
  }
  return mesh;
}

vtkIdType CountFacesInView(vtkAdaptiveRefinementMapper* mapper)
{
  return mapper->GetNumberOfCoarseFaces() - mapper->GetNumberOfCulledFaces();
}

struct View
{
  View()
  {
    this->Window->SetMultiSamples(0);
    this->Window->SetSize(300, 200);
    this->Window->AddRenderer(this->Renderer);
    this->Actor->SetMapper(this->Mapper);
    this->Renderer->AddActor(this->Actor);
    this->Metric->SetReferenceLength(0.5);
    this->Recipe->SetMetric(this->Metric);
    this->Recipe->SetMaximumLevel(5); // keeps single faces small compared with the target
    this->Mapper->SetRefinement(this->Recipe);
  }

  // Flies low over the hills while turning.
  void Fly(double time)
  {
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(0.6 * time - 0.6, -0.5, 0.35);
    camera->SetFocalPoint(0.3 * time, 0.2 * std::sin(3.0 * time), 0.0);
    camera->SetViewUp(0.0, 0.0, 1.0);
    this->Render();
  }

  void Render()
  {
    this->Renderer->ResetCameraClippingRange();
    this->Window->Render();
  }

  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkActor> Actor;
  vtkNew<vtkAdaptiveRefinementMapper> Mapper;
  vtkNew<vtkAdaptiveRefinement> Recipe;
  vtkNew<vtkScreenEdgeDepthTagMetric> Metric;
};

void TestFlight(RelevoCheck& check, int rule, int policy)
{
  View view;
  view.Mapper->SetInputData(MakeHills(50));
  view.Recipe->SetLevelRule(rule);
  view.Recipe->SetSegmentPolicy(policy);
  constexpr vtkIdType target = 40000;
  view.Mapper->SetTargetNumberOfTriangles(target);
  CHECK_EQUAL(view.Mapper->GetTargetNumberOfTriangles(), target);
  const int frames = 40;
  double last = 0.0;
  double lastChange = 0.0;
  for (int i = 0; i < frames; ++i)
  {
    view.Fly(static_cast<double>(i) / frames);
    CHECK_NEAR(
      static_cast<double>(view.Mapper->GetNumberOfDrawnTriangles()), target, 0.05 * target);
    const double offset = view.Mapper->GetLevelOffset();
    // The offset does not jump.
    if (i > 0)
    {
      CHECK_NEAR(offset, last, 0.5);
      CHECK_GREATER((offset - last) * lastChange, -0.001);
      lastChange = offset - last;
    }
    last = offset;
  }

  // With a still camera, levels are not selected again.
  const vtkIdType selections = view.Mapper->GetNumberOfSelections();
  CHECK_EQUAL(selections, frames);
  for (int i = 0; i < 5; ++i)
  {
    view.Render();
  }
  CHECK_EQUAL(view.Mapper->GetNumberOfSelections(), selections);

  // The filter creates the same mesh.
  const vtkIdType drawn = view.Mapper->GetNumberOfDrawnTriangles();
  const vtkIdType culled = view.Mapper->GetNumberOfCulledTriangles();
  view.Recipe->SetLevelOffset(view.Mapper->GetLevelOffset());
  vtkNew<vtkAdaptiveRefinementFilter> filter;
  filter->SetInputData(view.Mapper->GetInput());
  filter->SetRefinement(view.Recipe);
  filter->SetCamera(view.Renderer->GetActiveCamera());
  filter->SetViewportSize(300, 200);
  filter->Update();
  CHECK(culled > 0 && filter->GetOutput()->GetNumberOfPolys() == drawn + culled);

  // The recipe's offset does not change the sum of both.
  view.Render();
  CHECK_EQUAL(view.Mapper->GetNumberOfDrawnTriangles(), drawn);
  CHECK_NEAR(view.Mapper->GetLevelOffset(), 0.0, 1e-9);
}

// A target is a plain value; removing it restores the levels.
void TestSetting(RelevoCheck& check)
{
  View view;
  view.Mapper->SetInputData(MakeHills(30));
  view.Fly(0.5);
  const vtkIdType all = view.Mapper->GetNumberOfDrawnTriangles();
  CHECK_EQUAL(view.Mapper->GetLevelOffset(), 0.0);
  const vtkIdType meshes = view.Mapper->GetNumberOfBufferBuilds();
  const vtkIdType shaders = view.Mapper->GetNumberOfShaderBuilds();
  for (const vtkIdType target : { 10000, 30000, 5000 })
  {
    CHECK_CASE(target);
    view.Mapper->SetTargetNumberOfTriangles(target);
    view.Render();
    CHECK_NEAR(static_cast<double>(view.Mapper->GetNumberOfDrawnTriangles()),
      static_cast<double>(target), 0.05 * static_cast<double>(target));
  }
  view.Mapper->SetTargetNumberOfTriangles(1);
  view.Render();
  CHECK_EQUAL(view.Mapper->GetNumberOfDrawnTriangles(), CountFacesInView(view.Mapper));
  view.Mapper->SetTargetNumberOfTriangles(0);
  view.Render();
  CHECK_EQUAL(view.Mapper->GetNumberOfDrawnTriangles(), all);
  CHECK_EQUAL(view.Mapper->GetLevelOffset(), 0.0);
  CHECK_EQUAL(view.Mapper->GetNumberOfBufferBuilds(), meshes);
  CHECK_EQUAL(view.Mapper->GetNumberOfShaderBuilds(), shaders);
  const vtkMTimeType time = view.Mapper->GetMTime();
  RelevoErrors errors(view.Mapper);
  view.Mapper->SetTargetNumberOfTriangles(-1);
  CHECK(errors.Said("TargetNumberOfTriangles"));
  CHECK_EQUAL(view.Mapper->GetTargetNumberOfTriangles(), 0);
  CHECK_EQUAL(view.Mapper->GetMTime(), time);
}

void TestBlocks(RelevoCheck& check)
{
  View view;
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(40);
  sphere->SetPhiResolution(40);
  sphere->SetRadius(0.2);
  sphere->Update();
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, MakeHills(40));
  blocks->SetBlock(1, sphere->GetOutput());
  view.Mapper->SetInputDataObject(blocks);
  view.Mapper->SetTargetNumberOfTriangles(30000);
  for (const double time : { 0.3, 0.4, 0.5 })
  {
    CHECK_CASE(time);
    view.Fly(time);
    CHECK_NEAR(static_cast<double>(view.Mapper->GetNumberOfDrawnTriangles()), 30000.0, 1500.0);
    CHECK_NOT_EQUAL(view.Mapper->GetLevelOffset(), 0.0);
  }
  view.Mapper->SetTargetNumberOfTriangles(0);
  view.Render();
  CHECK_GREATER(view.Mapper->GetNumberOfDrawnTriangles(), 60000);
  CHECK_EQUAL(view.Mapper->GetLevelOffset(), 0.0);
}

// No computer draws a million frames per second, so the number of triangles becomes minimal. For
// still frames, full detail returns at once.
void TestTime(RelevoCheck& check, vtkDataObject* data)
{
  View view;
  view.Mapper->SetInputDataObject(data);
  const auto fly = [&view](int frames)
  {
    for (int i = 0; i < frames; ++i)
    {
      view.Fly(0.4 + 0.001 * i);
    }
  };
  fly(4);
  const vtkIdType all = view.Mapper->GetNumberOfDrawnTriangles();
  view.Window->SetDesiredUpdateRate(1e6);
  fly(4);
  const vtkIdType coarse = CountFacesInView(view.Mapper);
  CHECK_EQUAL(view.Mapper->GetNumberOfDrawnTriangles(), coarse);
  CHECK_LESS(view.Mapper->GetLevelOffset(), 0.0);

  // With a still camera the levels settle.
  vtkIdType selections = view.Mapper->GetNumberOfSelections();
  for (int i = 0; i < 10; ++i)
  {
    view.Render();
  }
  CHECK_EQUAL(view.Mapper->GetNumberOfSelections(), selections);

  // The visible surface is picked.
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(view.Renderer);
  selector->SetArea(0, 0, 299, 199);
  vtkSmartPointer<vtkSelection>::Take(selector->Select());
  CHECK_EQUAL(view.Mapper->GetNumberOfDrawnTriangles(), coarse);
  CHECK_EQUAL(view.Mapper->GetNumberOfSelections(), selections);

  view.Window->SetDesiredUpdateRate(0.0001);
  view.Render();
  CHECK_EQUAL(view.Mapper->GetNumberOfDrawnTriangles(), all);
  CHECK_EQUAL(view.Mapper->GetLevelOffset(), 0.0);

  view.Mapper->UseAllocatedRenderTimeOff();
  view.Window->SetDesiredUpdateRate(1e6);
  fly(4);
  CHECK_EQUAL(view.Mapper->GetNumberOfDrawnTriangles(), all);

  // The smaller of both budgets is used. Translucent surfaces need many passes.
  view.Mapper->UseAllocatedRenderTimeOn();
  view.Mapper->SetTargetNumberOfTriangles(all / 2);
  view.Actor->GetProperty()->SetOpacity(0.5);
  view.Renderer->SetUseDepthPeeling(1);
  fly(8);
  CHECK_EQUAL(view.Mapper->GetNumberOfDrawnTriangles(), CountFacesInView(view.Mapper));
  view.Window->SetDesiredUpdateRate(0.0001);
  view.Render();
  CHECK_NEAR(static_cast<double>(view.Mapper->GetNumberOfDrawnTriangles()),
    0.5 * static_cast<double>(all), 0.025 * static_cast<double>(all));
}
}

int TestAdaptiveRefinementMapperBudget(int, char*[])
{
  RelevoCheck check;
  TestFlight(check, 0, 0);
  TestFlight(check, 1, 0);
  TestFlight(check, 0, 1);
  TestSetting(check);
  TestBlocks(check);
  TestTime(check, MakeHills(30));
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, MakeHills(20));
  blocks->SetBlock(1, MakeHills(10));
  TestTime(check, blocks);
  return check.GetResult();
}
