// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves methods.md on hardware tessellation. In a context older than OpenGL 4.0
// (MESA_GL_VERSION_OVERRIDE=3.3), only its error is tested.
#include "RelevoDisplacements.h"
#include "RelevoMethods.h"
#include "RelevoPicks.h"
#include "RelevoPrimitiveCount.h"
#include "RelevoSurfaces.h"
#include "RelevoTestMeshes.h"

#include "Methods/HardwareTessellation.h"
#include "vtkDataObject.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPNTriangleSurface.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkShaderProperty.h"

#include <algorithm>
#include <iostream>
#include <set>

namespace
{
using namespace RelevoMeshes;
using Mapper = vtkAdaptiveRefinementMapper;

void AddScalars(vtkPolyData* mesh)
{
  vtkNew<vtkFloatArray> values;
  values->SetName("Values");
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    values->InsertNextValue(static_cast<float>(i * 7 % 10) * 0.1f);
  }
  mesh->GetPointData()->SetScalars(values);
}

// Compares the triangle count with that of OpenGL.
void CheckCount(RelevoCheck& check, RelevoScene& scene)
{
  const vtkIdType count = RelevoPrimitiveCount::CountTriangles(scene);
  scene.Render(); // the actor is visible again
  CHECK_GREATER(count, 0);
  CHECK_EQUAL(count, scene.GetMapper(0)->GetNumberOfDrawnTriangles());
}

struct Tester
{
  RelevoCheck& check;
  RelevoComparison& Comparison;

  // Compares one scene drawn by ARKFPI and by hardware tessellation.
  void Compare(const std::string& name, const RelevoTolerance& tolerance,
    const RelevoComparison::Builder& build) const
  {
    RelevoScene scene(RelevoScene::Refining);
    build(scene);
    Mapper* mapper = scene.GetMapper(0);
    mapper->SetMethodToARKFPI();
    scene.ResetCameras();
    RelevoErrors errors(mapper);
    scene.Render();
    const RelevoPicture expected(scene.Window);
    const vtkIdType uploads = mapper->GetNumberOfBufferBuilds();
    mapper->SetMethodToHardwareTessellation();
    scene.Render();
    const RelevoPicture actual(scene.Window);
    CHECK_EQUAL(mapper->GetMethodInUse(), Mapper::METHOD_HARDWARE_TESSELLATION);
    CHECK_EQUAL(mapper->GetNumberOfBufferBuilds(), uploads);
    CHECK(errors.None());
    this->Comparison.Compare("Tessellation." + name, tolerance, actual, expected);
    mapper->SetMethodToARKFPI();
    scene.Render();
    this->Comparison.Compare(
      "Tessellation." + name + ".Back", RelevoTolerance(), RelevoPicture(scene.Window), expected);
  }
};

// A plane face looks the same however it is split.
const RelevoTolerance Tight{ 1, 1e-6, 10 };
// Points inside faces differ, and so do the surfaces between them, most at coarse levels.
const RelevoTolerance Fine{ 4, 1e-3, 200 };
const RelevoTolerance Close{ 8, 5e-2, 900 };

void TestFlat(const Tester& tester)
{
  tester.Compare("Flat", Tight,
    [](RelevoScene& s)
    { s.Add(Tagged(Sphere(9, 7), 6), MakeRecipe(6))->GetProperty()->SetInterpolationToFlat(); });
}

void TestSurfaces(const Tester& tester)
{
  const RelevoTolerance steep{ 48, 5e-2, 300 };
  for (const auto& kind : RelevoMakeSurfaces())
  {
    const bool isSteep = kind.first.find("fur") != std::string::npos;
    tester.Compare(kind.first, isSteep ? steep : Fine,
      [&](RelevoScene& s) { s.Add(Sphere(9, 7), MakeRecipe(5, kind.second)); });
  }
}

void TestTagged(const Tester& tester)
{
  vtkNew<vtkPNTriangleSurface> surface;
  tester.Compare("Tagged", Close,
    [&](RelevoScene& s) { s.Add(Tagged(Sphere(9, 7), 5), MakeRecipe(5, surface)); });
}

void TestDisplaced(const Tester& tester)
{
  vtkNew<RelevoHeights> smooth;
  smooth->FillWaves();
  vtkNew<RelevoHeights> holes;
  holes->FillWavesWithHoles();
  tester.Compare("Displaced", Close,
    [&](RelevoScene& s)
    { s.Add(Plane(5, 4), MakeRecipe(5, nullptr, MakeDisplacement(smooth, 0.05))); });
  tester.Compare("Holes", Close,
    [&](RelevoScene& s)
    { s.Add(Plane(5, 4), MakeRecipe(5, nullptr, MakeDisplacement(holes, 0.03))); });
}

void TestLook(const Tester& tester)
{
  vtkNew<vtkPNTriangleSurface> surface;
  tester.Compare("Turned", Fine,
    [&](RelevoScene& s)
    { s.Add(Moebius(), MakeRecipe(5, surface))->GetProperty()->BackfaceCullingOn(); });
  tester.Compare("Scalars", Fine,
    [&](RelevoScene& s)
    {
      Mesh mesh = Sphere(9, 7);
      AddScalars(mesh);
      vtkMapper* mapper = s.Add(mesh, MakeRecipe(5, surface))->GetMapper();
      mapper->InterpolateScalarsBeforeMappingOn();
    });
  tester.Compare("Clipped", Fine,
    [&](RelevoScene& s)
    {
      vtkNew<vtkPlane> plane;
      plane->SetNormal(1, 0.5, 0.2);
      s.Add(Sphere(9, 7), MakeRecipe(5, surface))->GetMapper()->AddClippingPlane(plane);
    });
  tester.Compare("Peeled", Fine,
    [&](RelevoScene& s)
    {
      s.Renderer->UseDepthPeelingOn();
      s.Add(Sphere(9, 7), MakeRecipe(5, surface))->GetProperty()->SetOpacity(0.5);
    });
}

void TestColors(const Tester& tester)
{
  for (int mode : { 0, 1, 2 })
  {
    tester.Compare("Colors" + std::to_string(mode), Tight,
      [&](RelevoScene& s)
      {
        s.Add(Tagged(Sphere(9, 7), 5), MakeRecipe(5))->GetProperty()->SetInterpolationToFlat();
        mode == 0     ? s.GetMapper(0)->SetColorModeToLevel()
          : mode == 1 ? s.GetMapper(0)->SetColorModeToPattern()
                      : s.GetMapper(0)->SetColorModeToMetric();
      });
  }
}

void TestBlocks(const Tester& tester)
{
  vtkNew<vtkPNTriangleSurface> surface;
  tester.Compare("Blocks", Fine,
    [&](RelevoScene& s)
    {
      const double aside[3] = { 0.5, 0.3, 0 };
      vtkNew<vtkMultiBlockDataSet> blocks;
      blocks->SetBlock(0, Sphere(9, 7));
      blocks->SetBlock(1, Moved(Sphere(9, 7), 0.5, aside, VTK_FLOAT));
      s.Add(blocks, MakeRecipe(5, surface));
    });
}

// Lines and points are drawn by ARKFPI.
void TestLinesAndPoints(RelevoCheck& check)
{
  for (int representation : { VTK_WIREFRAME, VTK_POINTS })
  {
    CHECK_CASE(representation);
    RelevoScene scene(RelevoScene::Refining);
    scene.Add(Sphere(9, 7), MakeRecipe(3))->GetProperty()->SetRepresentation(representation);
    scene.GetMapper(0)->SetMethodToHardwareTessellation();
    RelevoErrors errors(scene.GetMapper(0));
    scene.ResetCameras();
    scene.Render();
    CHECK_EQUAL(scene.GetMapper(0)->GetMethodInUse(), Mapper::METHOD_ARKFPI);
    CHECK_GREATER(RelevoPicture(scene.Window).CountForeground(), 1000);
    CHECK(errors.None());
  }
}

// Edges of refined triangles, for levels where both methods have the same triangles.
void TestEdges(const Tester& tester)
{
  tester.Compare("Edges", { 1, 1e-6, 10 },
    [](RelevoScene& s)
    {
      vtkProperty* property = s.Add(Mixed(), MakeRecipe(0))->GetProperty();
      property->EdgeVisibilityOn();
      property->SetLineWidth(3);
    });
}

// Hardware selection finds the same cells and points as for ARKFPI.
void TestSelection(RelevoCheck& check)
{
  RelevoScene scene(RelevoScene::Refining);
  scene.Add(Tagged(Mixed(), 4), MakeRecipe(4));
  scene.ResetCameras();
  scene.Render();
  for (int association :
    { vtkDataObject::FIELD_ASSOCIATION_CELLS, vtkDataObject::FIELD_ASSOCIATION_POINTS })
  {
    scene.GetMapper(0)->SetMethodToARKFPI();
    const auto expected = RelevoPicks::SelectPixels(scene, association);
    scene.GetMapper(0)->SetMethodToHardwareTessellation();
    const auto actual = RelevoPicks::SelectPixels(scene, association);
    CHECK_EQUAL(actual.size(), expected.size());
    size_t hits = 0;
    size_t wrong = 0;
    std::set<vtkIdType> ids[2];
    for (size_t i = 0; i < std::min(actual.size(), expected.size()); ++i)
    {
      hits += actual[i].Id >= 0;
      wrong += !(actual[i] == expected[i]);
      ids[0].insert(expected[i].Id);
      ids[1].insert(actual[i].Id);
    }
    std::cout << "Selection: " << wrong << " of " << hits << " pixels differ" << std::endl;
    CHECK_GREATER(hits, 100);
    CHECK_LESS_EQUAL(wrong, 5); // along the silhouette
    CHECK_EQUAL(ids[0], ids[1]);
  }
}

void TestCounts(RelevoCheck& check)
{
  // Counts by hand: one triangle, a fan of six, two rings, three rings.
  const int segments[][4] = { { 1, 1, 1, 1 }, { 2, 2, 2, 6 }, { 3, 3, 3, 13 }, { 4, 4, 4, 24 },
    { 4, 1, 2, 4 + 1 + 2 + 6 + 6 }, { 128, 64, 100, 6144 }, { 5, 1, 1, 7 + 9 + 3 * 4 + 1 } };
  for (const int* s : segments)
  {
    CHECK_EQUAL(relevo::HardwareTessellation::CountTriangles(s), s[3]);
  }
  for (bool whole : { false, true })
  {
    RelevoScene scene(RelevoScene::Refining);
    auto recipe = MakeRecipe(6);
    recipe->SetSegmentPolicy(
      whole ? vtkAdaptiveRefinement::WHOLE_NUMBERS : vtkAdaptiveRefinement::POWERS_OF_TWO);
    scene.Add(Tagged(Sphere(9, 7), 6), recipe);
    scene.GetMapper(0)->SetMethodToHardwareTessellation();
    scene.ResetCameras();
    CheckCount(check, scene);
    // Culled faces are counted separately.
    const vtkIdType all = scene.GetMapper(0)->GetNumberOfDrawnTriangles();
    scene.Renderer->GetActiveCamera()->Zoom(8);
    scene.Render();
    CHECK_GREATER(scene.GetMapper(0)->GetNumberOfCulledFaces(), 0);
    CHECK_EQUAL(scene.CountTriangles(), all);
    CheckCount(check, scene);
  }
}

// Level 7 is drawn with the 64 segments of level 6.
void TestMostSegments(RelevoCheck& check, RelevoComparison& comparison)
{
  vtkNew<vtkPNTriangleSurface> surface;
  auto recipe = MakeRecipe(7, surface);
  RelevoScene scene(RelevoScene::Refining);
  scene.Add(Sphere(3, 3), recipe);
  scene.GetMapper(0)->SetMethodToHardwareTessellation();
  scene.ResetCameras();
  CheckCount(check, scene);
  CHECK_EQUAL(scene.GetMapper(0)->GetNumberOfDrawnTriangles(),
    6144 * scene.GetMapper(0)->GetNumberOfCoarseFaces());
  const RelevoPicture level7(scene.Window);
  recipe->SetMaximumLevel(6);
  scene.Render();
  comparison.Compare(
    "Tessellation.MaximumSegments", RelevoTolerance(), level7, RelevoPicture(scene.Window));
}

// Live parameters rebuild nothing, released resources are restored, and windows are independent.
void TestLife(RelevoCheck& check, RelevoComparison& comparison)
{
  vtkNew<RelevoHeights> rough;
  rough->FillRandom(32, 32, 9);
  auto displacement = MakeDisplacement(rough, 0.1);
  auto recipe = MakeRecipe(3, nullptr, displacement);
  Mesh mesh = Textured(Sphere(9, 7));
  RelevoScene scenes[2] = { RelevoScene(RelevoScene::Refining),
    RelevoScene(RelevoScene::Refining) };
  for (RelevoScene& scene : scenes)
  {
    scene.Add(mesh, recipe);
    scene.GetMapper(0)->SetMethodToHardwareTessellation();
    scene.ResetCameras();
  }
  RelevoScene& scene = scenes[0];
  Mapper* mapper = scene.GetMapper(0);
  RelevoErrors errors(mapper);
  scene.Render();
  const RelevoPicture expected(scene.Window);
  scenes[1].Render();
  comparison.Compare(
    "Tessellation.OtherWindow", RelevoTolerance(), RelevoPicture(scenes[1].Window), expected);

  const vtkIdType shaders = mapper->GetNumberOfShaderBuilds();
  const vtkIdType uploads = mapper->GetNumberOfBufferBuilds();
  const vtkIdType selections = mapper->GetNumberOfSelections();
  const vtkTypeInt64 memory = mapper->GetGraphicsMemorySize();
  displacement->SetScale(0.2);
  scene.Render();
  CHECK_NOT_EQUAL(RelevoPicture(scene.Window).Colors, expected.Colors);
  displacement->SetScale(0.1);
  scene.Render();
  comparison.Compare("Tessellation.Live", RelevoTolerance(), RelevoPicture(scene.Window), expected);
  CHECK_EQUAL(mapper->GetNumberOfShaderBuilds(), shaders);
  CHECK_EQUAL(mapper->GetNumberOfBufferBuilds(), uploads);
  CHECK_EQUAL(mapper->GetNumberOfSelections(), selections);

  mapper->ReleaseGraphicsResources(scene.Window);
  CHECK_LESS(mapper->GetGraphicsMemorySize(), memory);
  scene.Render();
  comparison.Compare(
    "Tessellation.Released", RelevoTolerance(), RelevoPicture(scene.Window), expected);
  CHECK_EQUAL(mapper->GetGraphicsMemorySize(), memory);

  CHECK_EQUAL(mapper->GetNumberOfDrawCalls(), 1);

  // The same actor moves to the other window and back.
  const vtkSmartPointer<vtkActor> actor = scene.GetActor(0);
  scene.Renderer->RemoveActor(actor);
  scenes[1].Renderer->RemoveActor(scenes[1].GetActor(0));
  scenes[1].Renderer->AddActor(actor);
  scenes[1].Render();
  comparison.Compare(
    "Tessellation.MovedAway", RelevoTolerance(), RelevoPicture(scenes[1].Window), expected);
  scenes[1].Renderer->RemoveActor(actor);
  scene.Renderer->AddActor(actor);
  scene.Render();
  comparison.Compare(
    "Tessellation.MovedBack", RelevoTolerance(), RelevoPicture(scene.Window), expected);
  scene.Window->Finalize();
  scene.Render();
  comparison.Compare(
    "Tessellation.Finalized", RelevoTolerance(), RelevoPicture(scene.Window), expected);
  CHECK(errors.None());
}

// Hardware tessellation cannot draw the scene: expects one error with these words and the picture
// of ARKFPI.
void ExpectARKFPI(RelevoCheck& check, RelevoComparison& comparison, const std::string& name,
  RelevoScene& scene, const std::string& words)
{
  Mapper* mapper = scene.GetMapper(0);
  mapper->SetMethodToARKFPI();
  RelevoErrors errors(mapper);
  scene.ResetCameras();
  scene.Render();
  CHECK(errors.None());
  const RelevoPicture expected(scene.Window);
  mapper->SetMethodToHardwareTessellation();
  scene.Render();
  CHECK(errors.Said(words));
  CHECK_EQUAL(mapper->GetMethodInUse(), Mapper::METHOD_ARKFPI);
  comparison.Compare(
    "Tessellation." + name, RelevoTolerance(), RelevoPicture(scene.Window), expected);
  scene.Render();
  CHECK(errors.None());
}

// A shader replacement that works only in a vertex shader gives an error and the picture of ARKFPI.
void TestFailure(RelevoCheck& check, RelevoComparison& comparison)
{
  RelevoScene scene(RelevoScene::Refining);
  vtkActor* actor = scene.Add(Sphere(9, 7), MakeRecipe(3));
  actor->GetShaderProperty()->AddVertexShaderReplacement("//VTK::CustomEnd::Impl", true,
    "//VTK::CustomEnd::Impl\n  if (gl_InstanceID < 0) gl_Position = vec4(0.0);\n", false);
  ExpectARKFPI(check, comparison, "Failure", scene, "gl_InstanceID");
  // Without the replacement it works.
  actor->GetShaderProperty()->ClearAllVertexShaderReplacements();
  RelevoErrors errors(scene.GetMapper(0));
  scene.Render();
  CHECK(errors.None());
  CHECK_EQUAL(scene.GetMapper(0)->GetMethodInUse(), Mapper::METHOD_HARDWARE_TESSELLATION);
}

void TestOldContext(RelevoCheck& check, RelevoComparison& comparison)
{
  RelevoScene scene(RelevoScene::Refining);
  scene.Add(Sphere(9, 7), MakeRecipe(3));
  ExpectARKFPI(check, comparison, "OldContext", scene, "OpenGL 4.0");
}
}

int TestAdaptiveRefinementMapperTessellation(int argc, char* argv[])
{
  RelevoCheck check;
  RelevoComparison comparison(check, argc, argv);
  if (!RelevoMethods::HasTessellation())
  {
    TestOldContext(check, comparison);
    return check.GetResult();
  }
  const Tester tester{ check, comparison };
  TestFlat(tester);
  TestSurfaces(tester);
  TestTagged(tester);
  TestDisplaced(tester);
  TestLook(tester);
  TestColors(tester);
  TestBlocks(tester);
  TestLinesAndPoints(check);
  TestEdges(tester);
  TestSelection(check);
  TestCounts(check);
  TestMostSegments(check, comparison);
  TestLife(check, comparison);
  TestFailure(check, comparison);
  return check.GetResult();
}
