// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves that level selection on the graphics card gives the same pictures and counts as on the
// CPU, and does nothing twice.
#include "RelevoDisplacements.h"
#include "RelevoScene.h"
#include "RelevoTestMeshes.h"

#include "vtkDistanceDepthTagMetric.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPNTriangleSurface.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkScreenEdgeDepthTagMetric.h"
#include "vtkSilhouetteDepthTagMetric.h"

namespace
{
using namespace RelevoMeshes;
using Mapper = vtkAdaptiveRefinementMapper;

bool HasCompute(vtkRenderWindow* window)
{
  int major = 0;
  int minor = 0;
  vtkOpenGLRenderWindow::SafeDownCast(window)->GetOpenGLVersion(major, minor);
  return major > 4 || (major == 4 && minor >= 3);
}

void SetDevice(RelevoScene& scene, int device)
{
  for (size_t i = 0; i < scene.GetNumberOfActors(); ++i)
  {
    scene.GetMapper(i)->SetSelectionDevice(device);
  }
}

// Draws a scene with both devices from three positions, then changes the device in the same window.
void Compare(RelevoCheck& check, RelevoComparison& comparison, const std::string& name,
  const RelevoComparison::Builder& build, int expectedDevice = Mapper::SELECTION_DEVICE_GPU)
{
  RelevoScene onCPU(RelevoScene::Refining);
  RelevoScene onGPU(RelevoScene::Refining);
  build(onCPU);
  build(onGPU);
  SetDevice(onCPU, Mapper::SELECTION_DEVICE_CPU);
  SetDevice(onGPU, Mapper::SELECTION_DEVICE_GPU);
  onCPU.ResetCameras();
  const auto compare = [&](const std::string& step)
  {
    comparison.Compare("Compute." + name + "." + step, RelevoTolerance(),
      RelevoPicture(onGPU.Window), RelevoPicture(onCPU.Window));
  };
  for (const char* step : { "Whole", "Close", "Far" })
  {
    onCPU.Render();
    onGPU.CopyCameras(onCPU);
    onGPU.Renderer->GetActiveCamera()->Modified(); // a copy does not call it
    onGPU.Render();
    compare(step);
    for (size_t i = 0; i < onCPU.GetNumberOfActors(); ++i)
    {
      Mapper* cpu = onCPU.GetMapper(i);
      Mapper* gpu = onGPU.GetMapper(i);
      CHECK_EQUAL(cpu->GetSelectionDeviceInUse(), Mapper::SELECTION_DEVICE_CPU);
      CHECK_EQUAL(gpu->GetSelectionDeviceInUse(), expectedDevice);
      CHECK_EQUAL(gpu->GetNumberOfDrawnTriangles(), cpu->GetNumberOfDrawnTriangles());
      CHECK_EQUAL(gpu->GetNumberOfCulledTriangles(), cpu->GetNumberOfCulledTriangles());
      CHECK_EQUAL(gpu->GetNumberOfUsedPatterns(), cpu->GetNumberOfUsedPatterns());
      CHECK_EQUAL(gpu->GetNumberOfCulledFaces(), cpu->GetNumberOfCulledFaces());
      CHECK_EQUAL(gpu->GetNumberOfSelections(), cpu->GetNumberOfSelections());
      CHECK_GREATER(gpu->GetNumberOfDrawnTriangles(), 0);
    }
    onCPU.Renderer->GetActiveCamera()->Dolly(step == std::string("Whole") ? 1.7 : 0.3);
    onCPU.Renderer->ResetCameraClippingRange();
  }
  onCPU.ResetCameras();
  for (int device : { Mapper::SELECTION_DEVICE_CPU, Mapper::SELECTION_DEVICE_GPU })
  {
    onCPU.Render();
    onGPU.CopyCameras(onCPU);
    onGPU.Renderer->GetActiveCamera()->Modified(); // a copy does not call it
    SetDevice(onGPU, device);
    onGPU.Render();
    compare(device == Mapper::SELECTION_DEVICE_CPU ? "OnCPU" : "Back");
  }
}

vtkSmartPointer<vtkAdaptiveRefinement> MakeRecipe(int level, vtkDepthTagMetric* metric,
  vtkRefinementSurface* surface = nullptr, vtkDisplacement* displacement = nullptr)
{
  auto recipe = vtkSmartPointer<vtkAdaptiveRefinement>::New();
  recipe->SetMaximumLevel(level);
  recipe->SetMetric(metric);
  recipe->SetSurface(surface);
  recipe->SetDisplacement(displacement);
  return recipe;
}

vtkSmartPointer<vtkDistanceDepthTagMetric> MakeDistanceMetric()
{
  auto metric = vtkSmartPointer<vtkDistanceDepthTagMetric>::New();
  metric->SetMaximumDistance(4.0);
  return metric;
}

void CheckSettings(RelevoCheck& check, Mapper* mapper, RelevoErrors& errors)
{
  mapper->SetSelectionDevice(3);
  CHECK(errors.Said("SelectionDevice must be one of SELECTION_DEVICE_AUTOMATIC (0)"));
  CHECK_EQUAL(mapper->GetSelectionDevice(), RelevoScene::GetSelectionDevice());
}

// The error is reported once, and the CPU selects.
void CheckWithoutCompute(RelevoCheck& check, RelevoScene& scene, RelevoErrors& errors)
{
  Mapper* mapper = scene.GetMapper(0);
  CHECK(errors.Said("Selection on the GPU needs OpenGL 4.3"));
  scene.Render();
  CHECK(errors.None());
  CHECK_GREATER(RelevoPicture(scene.Window).CountForeground(), 1000);
  CHECK_GREATER(mapper->GetNumberOfDrawnTriangles(), 200);
}

void CheckSelectedOnce(RelevoCheck& check, RelevoScene& scene)
{
  Mapper* mapper = scene.GetMapper(0);
  CHECK_EQUAL(mapper->GetNumberOfDrawCalls(), 1);
  const vtkIdType selections = mapper->GetNumberOfSelections();
  scene.Render();
  CHECK_EQUAL(mapper->GetNumberOfSelections(), selections);
  CHECK_GREATER(mapper->GetSelectionTime(), 0.0); // the time of the first frame
}

// Counters that were not read before the GPU memory is released are unknown until the next frame.
void CheckReleased(RelevoCheck& check, RelevoScene& scene)
{
  Mapper* mapper = scene.GetMapper(0);
  const vtkIdType triangles = mapper->GetNumberOfDrawnTriangles();
  scene.Renderer->GetActiveCamera()->Azimuth(20.0);
  scene.Render();
  mapper->ReleaseGraphicsResources(scene.Window);
  mapper->GetNumberOfDrawnTriangles();
  scene.Renderer->GetActiveCamera()->Azimuth(-20.0);
  scene.Render();
  mapper->GetRefinement()->GeomorphingOff(); // these patterns belong to the next frame
  CHECK_EQUAL(mapper->GetNumberOfDrawnTriangles(), triangles);
}

// Whether the graphics card can select. If not, the mapper must report it.
bool TestDevice(RelevoCheck& check)
{
  RelevoScene scene(RelevoScene::Refining);
  vtkActor* actor = scene.Add(Sphere(12, 10), MakeRecipe(4, MakeDistanceMetric()));
  Mapper* mapper = Mapper::SafeDownCast(actor->GetMapper());
  RelevoErrors errors(mapper);
  CheckSettings(check, mapper, errors);
  mapper->SetSelectionDeviceToGPU();
  scene.ResetCameras();
  scene.Render();
  const bool hasCompute = HasCompute(scene.Window);
  CHECK_EQUAL((mapper->GetSelectionDeviceInUse() == Mapper::SELECTION_DEVICE_GPU), hasCompute);
  if (!hasCompute)
  {
    CheckWithoutCompute(check, scene, errors);
    return false;
  }
  CHECK(errors.None());
  CheckSelectedOnce(check, scene);
  CheckReleased(check, scene);
  CHECK(errors.None());
  return true;
}

void TestCurved(RelevoCheck& check, RelevoComparison& comparison)
{
  const auto distance = MakeDistanceMetric();
  vtkNew<vtkPNTriangleSurface> curved;
  Compare(check, comparison, "Distance",
    [&](RelevoScene& s) { s.Add(Sphere(24, 20), MakeRecipe(4, distance, curved)); });
}

void TestPerEdge(RelevoCheck& check, RelevoComparison& comparison)
{
  vtkNew<vtkScreenEdgeDepthTagMetric> edges;
  edges->SetReferenceLength(6.0);
  Compare(check, comparison, "PerEdge",
    [&](RelevoScene& s)
    {
      auto recipe = MakeRecipe(5, edges);
      recipe->SetLevelRuleToPerEdge();
      recipe->SetLevelOffset(0.3);
      s.Add(Sphere(24, 20), recipe);
    });
}

void TestNoMorphing(RelevoCheck& check, RelevoComparison& comparison)
{
  vtkNew<vtkSilhouetteDepthTagMetric> silhouette;
  Compare(check, comparison, "NoMorphing",
    [&](RelevoScene& s)
    {
      auto recipe = MakeRecipe(5, silhouette);
      recipe->GeomorphingOff();
      s.Add(Sphere(24, 20), recipe);
    });
}

void TestDisplaced(RelevoCheck& check, RelevoComparison& comparison)
{
  const auto distance = MakeDistanceMetric();
  vtkNew<vtkPNTriangleSurface> curved;
  vtkNew<RelevoHeights> heights;
  heights->FillRandom(17, 13, 4);
  Compare(check, comparison, "Displaced",
    [&](RelevoScene& s)
    {
      s.Add(
        TexturedSphere(12, 10), MakeRecipe(4, distance, curved, MakeDisplacement(heights, 0.1)));
    });
}

void TestRepresentations(RelevoCheck& check, RelevoComparison& comparison)
{
  const auto distance = MakeDistanceMetric();
  Compare(check, comparison, "Wireframe",
    [&](RelevoScene& s)
    { s.Add(Mixed(), MakeRecipe(3, distance))->GetProperty()->SetRepresentationToWireframe(); });
  Compare(check, comparison, "Points",
    [&](RelevoScene& s)
    {
      vtkProperty* property = s.Add(Sphere(12, 10), MakeRecipe(3, distance))->GetProperty();
      property->SetRepresentationToPoints();
      property->SetPointSize(4);
    });
  Compare(check, comparison, "Edges",
    [&](RelevoScene& s)
    {
      vtkProperty* property = s.Add(Mixed(), MakeRecipe(3, distance))->GetProperty();
      property->EdgeVisibilityOn();
      property->VertexVisibilityOn();
    });
}

void TestBlocks(RelevoCheck& check, RelevoComparison& comparison)
{
  const auto distance = MakeDistanceMetric();
  Compare(check, comparison, "Blocks",
    [&](RelevoScene& s)
    {
      vtkNew<vtkMultiBlockDataSet> blocks;
      blocks->SetBlock(0, Cube());
      blocks->SetBlock(1, Make()); // empty
      blocks->SetBlock(2, Cone());
      s.Add(blocks, MakeRecipe(4, distance));
    });
}

void TestColors(RelevoCheck& check, RelevoComparison& comparison)
{
  const auto distance = MakeDistanceMetric();
  Compare(check, comparison, "Levels",
    [&](RelevoScene& s)
    {
      s.Add(Sphere(24, 20), MakeRecipe(4, distance));
      s.GetMapper(0)->SetColorModeToLevel();
    });
  Compare(
    check, comparison, "Tags",
    [&](RelevoScene& s)
    {
      s.Add(Sphere(24, 20), MakeRecipe(4, distance));
      s.GetMapper(0)->SetColorModeToMetric();
    },
    Mapper::SELECTION_DEVICE_CPU);
}

void TestWholeNumbers(RelevoCheck& check, RelevoComparison& comparison)
{
  const auto distance = MakeDistanceMetric();
  Compare(
    check, comparison, "WholeNumbers",
    [&](RelevoScene& s)
    {
      auto recipe = MakeRecipe(4, distance);
      recipe->SetSegmentPolicyToWholeNumbers();
      s.Add(Cube(), recipe);
    },
    Mapper::SELECTION_DEVICE_CPU);
}
}

int TestAdaptiveRefinementMapperCompute(int argc, char* argv[])
{
  RelevoCheck check;
  RelevoComparison comparison(check, argc, argv);
  if (!TestDevice(check))
  {
    return check.GetResult();
  }
  TestCurved(check, comparison);
  TestPerEdge(check, comparison);
  TestNoMorphing(check, comparison);
  TestDisplaced(check, comparison);
  TestRepresentations(check, comparison);
  TestBlocks(check, comparison);
  TestColors(check, comparison);
  TestWholeNumbers(check, comparison);
  return check.GetResult();
}
