// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves that the mapper's pictures equal baselines that were inspected. Other tests compare with
// vtkPolyDataMapper and cannot detect faults that both share. New pictures are written to the
// folder after -T; copy one into Testing/Baseline to make it the baseline.
#include "RelevoDisplacements.h"
#include "RelevoScene.h"
#include "RelevoTestMeshes.h"

#include "vtkDistanceDepthTagMetric.h"
#include "vtkImageDifference.h"
#include "vtkMath.h"
#include "vtkPNGReader.h"
#include "vtkPNTriangleSurface.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkTestUtilities.h"
#include "vtksys/SystemTools.hxx"

#include <cmath>
#include <iostream>

namespace
{
using namespace RelevoMeshes;
using Compare = std::function<void(const std::string&, const RelevoComparison::Builder&)>;

// Allowed sum of differences after vtkImageDifference's tolerance for shifted and antialiased
// pixels. VTK's tests accept 10 to 15.
constexpr double Threshold = 10.0;

void CompareWithBaseline(RelevoCheck& check, RelevoScene& scene, const std::string& name,
  const std::string& baselines, const std::string& folder)
{
  scene.Window->SetSize(400, 300);
  scene.Renderer->SetBackground(1, 1, 1);
  scene.ResetCameras();
  scene.Renderer->GetActiveCamera()->Zoom(1.5);
  scene.Render();
  const std::string drawn = folder + "/" + name + ".png";
  RelevoPicture(scene.Window).Save(drawn);
  const std::string baseline = baselines + "." + name + ".png";
  if (!vtksys::SystemTools::FileExists(baseline))
  {
    check.Fail(__FILE__, __LINE__, "no baseline " + baseline + " for " + drawn);
    return;
  }
  vtkNew<vtkPNGReader> actual;
  actual->SetFileName(drawn.c_str());
  vtkNew<vtkPNGReader> expected;
  expected->SetFileName(baseline.c_str());
  vtkNew<vtkImageDifference> difference;
  difference->SetInputConnection(actual->GetOutputPort());
  difference->SetImageConnection(expected->GetOutputPort());
  difference->Update();
  std::cout << name << ": error " << difference->GetThresholdedError() << std::endl;
  if (!(difference->GetThresholdedError() <= Threshold))
  {
    check.Fail(__FILE__, __LINE__,
      drawn + " differs from " + baseline + " by " +
        std::to_string(difference->GetThresholdedError()));
  }
}

void TestPatterns(const Compare& compare)
{
  vtkNew<vtkPNTriangleSurface> surface;
  compare("Patterns",
    [&](RelevoScene& s)
    {
      Mesh mesh = Sphere(10, 8);
      AddTags(mesh, 2, 4);
      vtkNew<vtkAdaptiveRefinement> recipe;
      recipe->SetMaximumLevel(4);
      recipe->SetSurface(surface);
      vtkProperty* property = s.Add(mesh, recipe)->GetProperty();
      property->SetColor(0.95, 0.85, 0.6);
      property->EdgeVisibilityOn();
    });
}

void TestCurved(const Compare& compare)
{
  vtkNew<vtkPNTriangleSurface> surface;
  compare("Curved",
    [&](RelevoScene& s)
    {
      Mesh mesh = Sphere(6, 5);
      vtkNew<vtkAdaptiveRefinement> recipe;
      recipe->SetSurface(surface);
      vtkProperty* property = s.Add(mesh, recipe)->GetProperty();
      property->SetColor(0.3, 0.6, 0.9);
      property->SetSpecular(0.8);
      property->SetSpecularPower(40);
    });
}

void TestDisplaced(const Compare& compare)
{
  vtkNew<vtkPNTriangleSurface> surface;
  vtkNew<RelevoHeights> waves;
  waves->Fill(64, 64,
    [](double u, double v)
    { return std::sin(6 * vtkMath::Pi() * u) * std::sin(5 * vtkMath::Pi() * v); });
  compare("Displaced",
    [&](RelevoScene& s)
    {
      vtkNew<vtkAdaptiveRefinement> recipe;
      recipe->SetMaximumLevel(6);
      recipe->SetSurface(surface);
      recipe->SetDisplacement(MakeDisplacement(waves, 0.06));
      s.Add(TexturedSphere(12, 8), recipe)->GetProperty()->SetColor(0.8, 0.5, 0.3);
    });
}

void TestHole(const Compare& compare)
{
  vtkNew<RelevoHeights> crater;
  crater->Fill(80, 80,
    [](double u, double v)
    {
      const double r = std::hypot(u - 0.5, v - 0.5);
      return std::exp(-80 * (r - 0.25) * (r - 0.25));
    });
  crater->Punch([](int x, int y) { return std::hypot(x - 39.5, y - 39.5) < 8; });
  compare("Hole",
    [&](RelevoScene& s)
    {
      vtkNew<vtkAdaptiveRefinement> recipe;
      recipe->SetMaximumLevel(6);
      recipe->SetDisplacement(MakeDisplacement(crater, 0.2));
      s.Add(Plane(3, 3), recipe)->GetProperty()->SetColor(0.5, 0.7, 0.4);
      s.MoveCamera = [](vtkCamera* camera) { camera->Elevation(-50); };
    });
}

void TestScalars(const Compare& compare)
{
  vtkNew<vtkPNTriangleSurface> surface;
  compare("Scalars",
    [&](RelevoScene& s)
    {
      Mesh mesh = Strips();
      vtkNew<vtkFloatArray> values;
      for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
      {
        values->InsertNextValue(static_cast<float>(mesh->GetPoint(i)[2]));
      }
      mesh->GetPointData()->SetScalars(values);
      vtkNew<vtkAdaptiveRefinement> recipe;
      recipe->SetMaximumLevel(4);
      recipe->SetSurface(surface);
      vtkMapper* mapper = s.Add(mesh, recipe)->GetMapper();
      mapper->SetScalarRange(-0.5, 0.5);
      mapper->InterpolateScalarsBeforeMappingOn();
    });
}

void TestDistance(const Compare& compare)
{
  compare("Distance",
    [&](RelevoScene& s)
    {
      vtkNew<vtkDistanceDepthTagMetric> metric;
      metric->SetMaximumDistance(2);
      vtkNew<vtkAdaptiveRefinement> recipe;
      recipe->SetMaximumLevel(5);
      recipe->SetMetric(metric);
      vtkProperty* property = s.Add(Plane(6, 6), recipe)->GetProperty();
      property->SetRepresentationToWireframe();
      property->SetColor(0.1, 0.2, 0.5);
      property->LightingOff();
      s.MoveCamera = [](vtkCamera* camera)
      {
        camera->Elevation(-60);
        camera->Dolly(2);
      };
    });
}
}

int TestAdaptiveRefinementMapperImages(int argc, char* argv[])
{
  RelevoCheck check;
  auto argument = [&](const char* flag, const char* otherwise)
  {
    char* text = vtkTestUtilities::GetArgOrEnvOrDefault(flag, argc, argv, "", otherwise);
    const std::string result = text;
    delete[] text;
    return result;
  };
  const std::string folder = argument("-T", ".");
  std::string baselines = argument("-V", "TestAdaptiveRefinementMapperImages.png");
  baselines = vtksys::SystemTools::GetFilenamePath(baselines) + "/" +
    vtksys::SystemTools::GetFilenameWithoutLastExtension(baselines);
  auto compare = [&](const std::string& name, const RelevoComparison::Builder& build)
  {
    RelevoScene scene(RelevoScene::Refining);
    build(scene);
    CompareWithBaseline(check, scene, name, baselines, folder);
  };

  TestPatterns(compare);
  TestCurved(compare);
  TestDisplaced(compare);
  TestHole(compare);
  TestScalars(compare);
  TestDistance(compare);
  return check.GetResult();
}
