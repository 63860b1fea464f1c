// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves that at level 0 the mapper draws what vtkPolyDataMapper draws: matrices, large
// coordinates, cameras, viewports, multisampling and render passes.
#include "RelevoScene.h"
#include "RelevoShadows.h"
#include "RelevoTestMeshes.h"

#include "vtkLight.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkOpenGLRenderer.h"
#include "vtkOpenGLVertexBufferObject.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderStepsPass.h"
#include "vtkSSAOPass.h"

namespace
{
using namespace RelevoMeshes;
using Compare = std::function<void(const std::string&, const RelevoComparison::Builder&)>;

const RelevoTolerance Tight{ 1, 2e-7, 0 };

Mesh Double(vtkPolyData* mesh, double scale, double x, double y, double z)
{
  const double offset[3] = { x, y, z };
  return Moved(mesh, scale, offset, VTK_DOUBLE);
}

void TestActors(const Compare& compare)
{
  compare("Rotated",
    [](RelevoScene& s)
    {
      vtkActor* actor = s.Add(Cube());
      actor->RotateX(33);
      actor->RotateZ(21);
      actor->SetPosition(3, -2, 1);
    });
  compare("Stretched", [](RelevoScene& s) { s.Add(Sphere(12, 10))->SetScale(1, 3, 0.4); });
  compare("Mirrored",
    [](RelevoScene& s)
    {
      vtkActor* actor = s.Add(Cone());
      actor->SetScale(-1, 1, 1);
      actor->GetProperty()->BackfaceCullingOn();
    });
  compare("MirroredTwoSided",
    [](RelevoScene& s)
    {
      vtkActor* actor = s.Add(Moebius());
      actor->SetScale(1, 1, -2);
      vtkNew<vtkProperty> back;
      back->SetColor(1, 0, 0);
      actor->SetBackfaceProperty(back);
    });
  compare("UserMatrix",
    [](RelevoScene& s)
    {
      vtkNew<vtkMatrix4x4> shear;
      shear->SetElement(0, 1, 0.7);
      shear->SetElement(2, 0, -0.4);
      s.Add(Sphere(12, 10))->SetUserMatrix(shear);
    });
}

void TestCoordinates(const Compare& compare)
{
  compare(
    "LargeDouble", [](RelevoScene& s) { s.Add(Double(Sphere(12, 10), 100, 5e6, -4e6, 3e6)); });
  compare("LargeDoubleCellsAndEdges",
    [](RelevoScene& s)
    {
      vtkActor* actor = s.Add(Double(Cube(), 10, 5e6, -4e6, 3e6));
      actor->GetProperty()->EdgeVisibilityOn();
      actor->RotateZ(30);
    });
  compare("LargeFloat",
    [](RelevoScene& s)
    {
      const double offset[3] = { 5e4, -4e4, 3e4 };
      s.Add(Moved(Sphere(12, 10), 100, offset, VTK_FLOAT));
    });
  compare("AlwaysShifted",
    [](RelevoScene& s)
    {
      vtkActor* actor = s.Add(Double(Sphere(12, 10), 1, 20, 30, 40));
      vtkOpenGLPolyDataMapper::SafeDownCast(actor->GetMapper())
        ->SetVBOShiftScaleMethod(vtkOpenGLVertexBufferObject::ALWAYS_AUTO_SHIFT_SCALE);
    });
  compare("NeverShifted",
    [](RelevoScene& s)
    {
      vtkActor* actor = s.Add(Double(Sphere(12, 10), 1, 200, 300, 400));
      vtkOpenGLPolyDataMapper::SafeDownCast(actor->GetMapper())
        ->SetVBOShiftScaleMethod(vtkOpenGLVertexBufferObject::DISABLE_SHIFT_SCALE);
    });
  compare("Tiny", [](RelevoScene& s) { s.Add(Double(Sphere(12, 10), 1e-6, 0, 0, 0)); });
  compare("Huge", [](RelevoScene& s) { s.Add(Double(Sphere(12, 10), 1e9, 0, 0, 0)); });
  compare("HugeFlatNormals",
    [](RelevoScene& s)
    { s.Add(Double(Sphere(12, 10), 1e9, 0, 0, 0))->GetProperty()->SetInterpolationToFlat(); });
}

void TestCameras(const Compare& compare)
{
  compare("Parallel",
    [](RelevoScene& s)
    {
      s.Add(Cube());
      s.Renderer->GetActiveCamera()->ParallelProjectionOn();
    });
  compare("ParallelFlatUnlitNormals",
    [](RelevoScene& s)
    {
      s.Add(Sphere(12, 10))->GetProperty()->SetInterpolationToFlat();
      s.Renderer->GetActiveCamera()->ParallelProjectionOn();
    });
  compare("Inside",
    [](RelevoScene& s)
    {
      s.Add(Sphere(12, 10));
      s.MoveCamera = [](vtkCamera* camera)
      {
        camera->SetPosition(0.1, 0.05, 0.2);
        camera->SetFocalPoint(1, 0.2, 0.3);
        camera->SetViewAngle(80);
      };
    });
}

void TestWindows(const Compare& compare)
{
  compare("Viewports",
    [](RelevoScene& s)
    {
      s.Renderer->SetViewport(0, 0, 0.4, 0.7);
      s.Add(Sphere(12, 10));
      vtkRenderer* right = s.AddRenderer(0.4, 0.2, 1, 1);
      right->SetBackground(0.5, 0.5, 0.5);
      s.Add(right, Cube());
    });
  compare("Layers",
    [](RelevoScene& s)
    {
      s.Add(Sphere(12, 10));
      s.Window->SetNumberOfLayers(2);
      vtkRenderer* front = s.AddRenderer(0, 0, 1, 1);
      front->SetLayer(1);
      s.Add(front, Cube())->SetScale(0.3);
    });
  compare("OddSize",
    [](RelevoScene& s)
    {
      s.Window->SetSize(317, 203);
      s.Add(Cone());
    });
  for (int samples : { 4, 8 })
  {
    compare("Multisampled" + std::to_string(samples),
      [samples](RelevoScene& s)
      {
        s.Window->SetMultiSamples(samples);
        s.Add(Sphere(12, 10))->GetProperty()->EdgeVisibilityOn();
      });
  }
  compare("FXAA",
    [](RelevoScene& s)
    {
      s.Renderer->UseFXAAOn();
      s.Add(Sphere(12, 10));
    });
}

void TestRenderPasses(const Compare& compare)
{
  compare("Shadows",
    [](RelevoScene& s)
    {
      s.Add(Sphere(12, 10));
      vtkActor* floor = s.Add(Plane(4, 3));
      floor->SetScale(4);
      floor->SetPosition(0, 0, -1);
      vtkNew<vtkLight> light;
      light->PositionalOn();
      light->SetPosition(1, 1, 4);
      light->SetFocalPoint(0, 0, 0);
      light->SetConeAngle(45);
      s.Renderer->AddLight(light);
      vtkOpenGLRenderer::SafeDownCast(s.Renderer)->SetPass(RelevoMakeShadowPass());
    });
  compare("AmbientOcclusion",
    [](RelevoScene& s)
    {
      s.Add(Sphere(12, 10));
      vtkActor* floor = s.Add(Plane(4, 3));
      floor->SetScale(4);
      floor->SetPosition(0, 0, -0.5);
      vtkNew<vtkRenderStepsPass> steps;
      vtkNew<vtkSSAOPass> occlusion;
      occlusion->SetRadius(0.5);
      occlusion->SetKernelSize(64);
      occlusion->SetDelegatePass(steps);
      vtkOpenGLRenderer::SafeDownCast(s.Renderer)->SetPass(occlusion);
    });
}
}

int TestAdaptiveRefinementMapperPlacement(int argc, char* argv[])
{
  RelevoCheck check;
  RelevoComparison comparison(check, argc, argv);
  auto compare = [&](const std::string& name, const RelevoComparison::Builder& build)
  { comparison.Compare("Placement." + name, Tight, build); };

  TestActors(compare);
  TestCoordinates(compare);
  TestCameras(compare);
  TestWindows(compare);
  TestRenderPasses(compare);
  return check.GetResult();
}
