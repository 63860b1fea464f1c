// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkRefinementPatternTable promises that patterns of a file draw every surface as the filter
// refines it, with every method and device. Tables may change between frames, and unsupported
// features give one error.
#include "RelevoCheck.h"
#include "RelevoPatternFiles.h"
#include "RelevoScene.h"
#include "RelevoSurfaces.h"
#include "RelevoTestMeshes.h"

#include "vtkAdaptiveRefinement.h"
#include "vtkPNTriangleSurface.h"
#include "vtkProperty.h"
#include "vtkRefinementPatternTable.h"
#include "vtkScreenEdgeDepthTagMetric.h"

namespace
{
using namespace RelevoMeshes;
using Mapper = vtkAdaptiveRefinementMapper;

// The tolerance is that of TestAdaptiveRefinementMapperTwin.
const RelevoTolerance Close{ 2, 2e-6, 10 };

constexpr int FileLevel = 4;

Mesh MakeMesh()
{
  Mesh mesh = Tagged(Sphere(9, 7), FileLevel);
  AddRandomScalarTags(mesh, 11);
  return mesh;
}

// On flat faces, the triangles are visible.
void TestTwins(RelevoComparison& comparison, vtkRefinementPatternTable* table)
{
  for (const auto& surface : RelevoMakeSurfaces())
  {
    const auto recipe = MakeRecipe(FileLevel, surface.second);
    recipe->SetPatternTable(table);
    comparison.Compare("PatternFiles." + surface.first, Close,
      [&](RelevoScene& scene)
      { scene.Add(MakeMesh(), recipe)->GetProperty()->SetInterpolationToFlat(); },
      { { "OtherTable", [&](RelevoScene&) { recipe->SetPatternTable(nullptr); } } });
  }
}

// A view-dependent metric, which uses nested patterns if it can morph.
void TestViewDependent(RelevoComparison& comparison, vtkRefinementPatternTable* table)
{
  vtkNew<vtkScreenEdgeDepthTagMetric> metric;
  vtkNew<vtkPNTriangleSurface> surface;
  const auto recipe = MakeRecipe(FileLevel, surface);
  recipe->SetMetric(metric);
  comparison.Compare("PatternFiles.View", Close,
    [&](RelevoScene& scene)
    { scene.Add(Sphere(9, 7), recipe)->GetProperty()->SetInterpolationToFlat(); },
    { { "Read", [&](RelevoScene&) { recipe->SetPatternTable(table); } },
      { "NotRead", [&](RelevoScene&) { recipe->SetPatternTable(nullptr); } } });
}

void TestMethods(RelevoCheck& check, vtkRefinementPatternTable* table)
{
  vtkNew<vtkPNTriangleSurface> surface;
  const auto recipe = MakeRecipe(FileLevel, surface);
  recipe->SetPatternTable(table);
  const vtkIdType expected = Refine(MakeMesh(), recipe)->GetNumberOfPolys();
  for (int device : { Mapper::SELECTION_DEVICE_CPU, Mapper::SELECTION_DEVICE_GPU })
  {
    CHECK_CASE(device);
    for (int method = Mapper::METHOD_ARKFPI; method <= Mapper::METHOD_UNIFORM; ++method)
    {
      RelevoScene scene(RelevoScene::Refining);
      scene.Add(MakeMesh(), recipe);
      RelevoErrors errors(scene.GetMapper(0));
      scene.GetMapper(0)->SetMethod(method);
      scene.GetMapper(0)->SetSelectionDevice(device);
      scene.ResetCameras();
      scene.Render();
      CHECK(errors.None());
      CHECK_EQUAL(scene.GetMapper(0)->GetMethodInUse(), method);
      CHECK_GREATER(RelevoPicture(scene.Window).CountForeground(), 10000);
      CHECK(
        method > Mapper::METHOD_ARK || scene.GetMapper(0)->GetNumberOfDrawnTriangles() == expected);
    }
  }
}

void TestErrors(RelevoCheck& check, vtkRefinementPatternTable* table)
{
  const auto recipe = MakeRecipe(2);
  recipe->SetPatternTable(table);
  recipe->GeomorphingOn();
  RelevoScene scene(RelevoScene::Refining);
  scene.Add(Sphere(9, 7), recipe);
  RelevoErrors errors(scene.GetMapper(0));
  scene.ResetCameras();
  scene.Render();
  CHECK(errors.Said("GeomorphingOff()"));
  CHECK_EQUAL(scene.GetMapper(0)->GetNumberOfDrawnTriangles(), 0);
  scene.Render();
  CHECK(errors.None()); // reported once
  recipe->SetSegmentPolicyToWholeNumbers();
  scene.Render();
  CHECK(errors.Said("SetSegmentPolicyToPowersOfTwo()"));
  recipe->SetSegmentPolicyToPowersOfTwo();
  recipe->GeomorphingOff();
  scene.Render();
  CHECK(errors.None());
  const vtkIdType drawn = scene.GetMapper(0)->GetNumberOfDrawnTriangles();
  CHECK_EQUAL(drawn, Refine(Sphere(9, 7), recipe)->GetNumberOfPolys());
}

// Levels that the file lacks give one warning.
void TestWarning(RelevoCheck& check, vtkRefinementPatternTable* table)
{
  const auto recipe = MakeRecipe(FileLevel + 1);
  recipe->SetPatternTable(table);
  RelevoScene scene(RelevoScene::Refining);
  scene.Add(Sphere(9, 7), recipe);
  RelevoErrors errors(scene.GetMapper(0));
  scene.ResetCameras();
  scene.Render();
  CHECK(errors.Warned("end at level"));
  CHECK_GREATER(scene.GetMapper(0)->GetNumberOfDrawnTriangles(), 0);
  scene.Render();
  CHECK(errors.None());
}
}

int TestAdaptiveRefinementMapperPatternFiles(int argc, char* argv[])
{
  RelevoCheck check;
  RelevoComparison comparison(check, argc, argv);
  const std::string fileName = comparison.GetFolder() + "/MapperPatternFiles.patterns";
  vtkNew<vtkRefinementPatternTable> table;
  if (CHECK(RelevoPatternFiles::WriteShifted(fileName, FileLevel)) &&
    CHECK(table->Read(fileName.c_str())))
  {
    TestTwins(comparison, table);
    TestViewDependent(comparison, table);
    TestMethods(check, table);
    TestErrors(check, table);
    TestWarning(check, table);
  }
  return check.GetResult();
}
