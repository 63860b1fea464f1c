// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves that culling faces that are not visible (guide.md) changes no picture, in any pass.
#include "RelevoDisplacements.h"
#include "RelevoScene.h"
#include "RelevoShadows.h"
#include "RelevoTestMeshes.h"
#include "RelevoTextures.h"

#include "vtkLight.h"
#include "vtkLookupTable.h"
#include "vtkOpenGLRenderer.h"
#include "vtkPNTriangleSurface.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkReverseSense.h"
#include "vtkShaderProperty.h"
#include "vtkTransform.h"

namespace
{
using namespace RelevoMeshes;

void Shade(vtkRenderer* renderer)
{
  vtkNew<vtkLight> light;
  light->SetPositional(1);
  light->SetConeAngle(40.0);
  light->SetPosition(4, 3, 5);
  light->SetFocalPoint(0, 0, 0);
  renderer->AddLight(light);
  vtkOpenGLRenderer::SafeDownCast(renderer)->SetPass(RelevoMakeShadowPass());
}

constexpr size_t Outline = 4;      // pixels where front and back have the same depth
constexpr size_t OpenOutline = 12; // for a surface that shows its inside

struct Tester
{
  RelevoCheck& check;
  RelevoComparison& Comparison;

  // Draws a scene twice, with all faces and with culling.
  void Compare(
    const std::string& name, size_t pixels, const RelevoComparison::Builder& build) const;

  // A sphere after a change, compared with vtkPolyDataMapper, which culls nothing. Returns the
  // number of culled faces.
  vtkIdType CompareOpened(const std::string& name, size_t pixels, vtkAdaptiveRefinement* recipe,
    const RelevoComparison::Builder& change) const;
};

void Tester::Compare(
  const std::string& name, size_t pixels, const RelevoComparison::Builder& build) const
{
  RelevoScene all(RelevoScene::Refining);
  RelevoScene culled(RelevoScene::Refining);
  for (RelevoScene* scene : { &all, &culled })
  {
    build(*scene);
    for (size_t i = 0; i < scene->GetNumberOfActors(); ++i)
    {
      scene->GetMapper(i)->SetFrustumCulling(scene == &culled);
      scene->GetMapper(i)->SetBackFaceCulling(scene == &culled);
    }
  }
  all.ResetCameras();
  for (double closer : { 1.0, 2.2 })
  {
    all.Renderer->GetActiveCamera()->Zoom(closer);
    all.Renderer->GetActiveCamera()->Yaw(2.0 * closer);
    all.Renderer->ResetCameraClippingRange();
    all.Render();
    culled.CopyCameras(all);
    culled.Renderer->GetActiveCamera()->Modified(); // otherwise some passes do not draw again
    culled.Render();
    RelevoTolerance tolerance;
    tolerance.Pixels = pixels;
    this->Comparison.Compare("Culling." + name + "." + std::to_string(closer), tolerance,
      RelevoPicture(culled.Window), RelevoPicture(all.Window));
    CHECK_EQUAL(culled.CountTriangles(), all.CountTriangles());
  }
  vtkIdType faces = 0;
  for (size_t i = 0; i < culled.GetNumberOfActors(); ++i)
  {
    faces += culled.GetMapper(i)->GetNumberOfCulledFaces();
    CHECK_EQUAL(all.GetMapper(i)->GetNumberOfCulledFaces(), 0);
  }
  CHECK_GREATER(faces, 0);
}

vtkIdType Tester::CompareOpened(const std::string& name, size_t pixels,
  vtkAdaptiveRefinement* recipe, const RelevoComparison::Builder& change) const
{
  RelevoScene twin(RelevoScene::Twin);
  RelevoScene refining(RelevoScene::Refining);
  for (RelevoScene* scene : { &twin, &refining })
  {
    scene->Add(TexturedSphere(24, 20), recipe);
    scene->Renderer->GetActiveCamera()->SetPosition(0.5, 0.8, 2.0);
    scene->Renderer->GetActiveCamera()->SetClippingRange(0.1, 10.0);
    change(*scene);
    scene->Render();
  }
  refining.GetMapper(0)->BackFaceCullingOn();
  refining.Render();
  RelevoTolerance tolerance;
  tolerance.Color = recipe ? 2 : 0;
  tolerance.Depth = recipe ? 2e-6 : 0.0;
  tolerance.Pixels = pixels;
  this->Comparison.Compare("Culling." + name + (recipe ? ".Curved" : ""), tolerance,
    RelevoPicture(refining.Window), RelevoPicture(twin.Window));
  return refining.GetMapper(0)->GetNumberOfCulledFaces();
}

vtkCamera* GetCamera(RelevoScene& scene)
{
  return scene.Renderer->GetActiveCamera();
}

void TestUncut(const Tester& tester, vtkAdaptiveRefinement* recipe)
{
  RelevoCheck& check = tester.check;
  const vtkIdType hidden = tester.CompareOpened("Uncut", OpenOutline, recipe, [](RelevoScene&) {});
  CHECK_GREATER(hidden, 100);
}

void TestNearPlanes(const Tester& tester, vtkAdaptiveRefinement* recipe)
{
  RelevoCheck& check = tester.check;
  for (double nearPlane : { 1.8, 2.1, 2.5 })
  {
    CHECK_CASE(nearPlane);
    const std::string name = "Near." + std::to_string(nearPlane);
    const vtkIdType cut = tester.CompareOpened(name, OpenOutline, recipe,
      [&](RelevoScene& s) { GetCamera(s)->SetClippingRange(nearPlane, 10.0); });
    CHECK_EQUAL(cut, 0);
    tester.CompareOpened(name + ".Parallel", OpenOutline, recipe,
      [&](RelevoScene& s)
      {
        GetCamera(s)->SetClippingRange(nearPlane, 10.0);
        GetCamera(s)->ParallelProjectionOn();
      });
  }
}

void TestDiscarded(const Tester& tester, vtkAdaptiveRefinement* recipe)
{
  tester.CompareOpened("CutOut", OpenOutline, recipe,
    [](RelevoScene& s)
    {
      s.GetActor(0)->SetTexture(RelevoTextures::Make(8, 8, 4,
        [](int x, int) {
          return RelevoTextures::Texel{ { 200, 200, 200, 255 * (x % 2) } };
        }));
    });
  tester.CompareOpened("Discarded", OpenOutline, recipe,
    [](RelevoScene& s)
    {
      s.GetActor(0)->GetShaderProperty()->AddFragmentShaderReplacement("//VTK::Light::Impl", true,
        "//VTK::Light::Impl\n  if (mod(gl_FragCoord.x, 16.0) < 8.0 && gl_FrontFacing) discard;\n",
        false);
    });
}

void TestForcedOpaque(const Tester& tester, vtkAdaptiveRefinement* recipe)
{
  tester.CompareOpened("ForcedOpaque", OpenOutline, recipe,
    [](RelevoScene& s)
    {
      s.GetActor(0)->ForceOpaqueOn();
      s.GetActor(0)->GetProperty()->SetOpacity(0.999);
    });
}

void TestSheared(const Tester& tester, vtkAdaptiveRefinement* recipe)
{
  for (bool parallel : { false, true })
  {
    tester.CompareOpened(parallel ? "Sheared.Parallel" : "Sheared", OpenOutline, recipe,
      [&](RelevoScene& s)
      {
        vtkNew<vtkTransform> transform;
        transform->Translate(0.6, -0.4, 0.7);
        transform->RotateY(25.0);
        GetCamera(s)->SetUserViewTransform(transform);
        GetCamera(s)->SetViewShear(0.4, 0.3, 1.0);
        GetCamera(s)->SetParallelProjection(parallel);
      });
  }
}

void TestMovedVertices(const Tester& tester)
{
  tester.CompareOpened("MovedVertices", 0, nullptr,
    [](RelevoScene& s)
    {
      // The mesh is mostly out of view, but the actor's shader moves it into view.
      s.Renderer->GetActiveCamera()->SetViewAngle(20.0);
      s.GetActor(0)->SetPosition(-0.7, 0.0, 0.0);
      s.GetActor(0)->GetShaderProperty()->AddVertexShaderReplacement("//VTK::Normal::Impl", true,
        "//VTK::Normal::Impl\n  vec4 aside = vertexMC + vec4(0.7, 0.0, 0.0, 0.0);\n", false);
      s.GetActor(0)->GetShaderProperty()->AddVertexShaderReplacement("//VTK::PositionVC::Impl",
        true, "//VTK::PositionVC::Impl\n  gl_Position = MCDCMatrix * aside;\n", false);
    });
}

void TestWide(const Tester& tester)
{
  for (int representation : { VTK_POINTS, VTK_WIREFRAME })
  {
    tester.CompareOpened("Wide." + std::to_string(representation), 0, nullptr,
      [&](RelevoScene& s)
      {
        vtkProperty* property = s.GetActor(0)->GetProperty();
        property->SetRepresentation(representation);
        property->SetLineWidth(25);
        property->SetPointSize(25);
        s.Renderer->GetActiveCamera()->SetViewAngle(14.0);
      });
  }
}

// A closed surface shows its inside, or shaders draw beyond the points of faces.
void TestOpened(const Tester& tester)
{
  vtkNew<vtkPNTriangleSurface> curved;
  for (const auto& recipe : { vtkSmartPointer<vtkAdaptiveRefinement>(), MakeRecipe(3, curved) })
  {
    TestUncut(tester, recipe);
    TestNearPlanes(tester, recipe);
    TestDiscarded(tester, recipe);
    TestForcedOpaque(tester, recipe);
    TestSheared(tester, recipe);
  }
  TestMovedVertices(tester);
  TestWide(tester);
}

void TestBacksHidden(const Tester& tester)
{
  vtkNew<vtkPNTriangleSurface> curved;
  vtkNew<RelevoHeights> heights;
  heights->FillRandom(17, 13, 4);
  const auto up = MakeDisplacementAlong(0, 0, 1, heights, 0.5);

  tester.Compare("Sphere", Outline, [](RelevoScene& s) { s.Add(Sphere(24, 20), MakeRecipe(2)); });
  tester.Compare(
    "Curved", Outline, [&](RelevoScene& s) { s.Add(Sphere(12, 10), MakeRecipe(4, curved)); });
  tester.Compare(
    "Displaced", 0, [&](RelevoScene& s) { s.Add(Plane(12, 12), MakeRecipe(4, nullptr, up)); });
  tester.Compare("Parallel", Outline,
    [](RelevoScene& s)
    {
      s.Add(Sphere(24, 20), MakeRecipe(2));
      s.Renderer->GetActiveCamera()->ParallelProjectionOn();
    });
  tester.Compare("InsideOut", 0,
    [](RelevoScene& s)
    {
      vtkNew<vtkReverseSense> reversed;
      reversed->SetInputData(Sphere(24, 20));
      reversed->ReverseCellsOn();
      reversed->Update();
      s.Add(reversed->GetOutput(), MakeRecipe(2));
    });
  tester.Compare("Moved", Outline,
    [](RelevoScene& s)
    {
      const double far[3] = { 4e6, 5e6, -3e6 };
      vtkActor* actor = s.Add(Moved(Sphere(24, 20), 100.0, far, VTK_DOUBLE), MakeRecipe(2));
      actor->RotateY(30);
      actor->SetScale(1, 2, 0.7);
    });
}

// Back faces of translucent surfaces are visible.
void TestTranslucent(const Tester& tester)
{
  tester.Compare("Translucent", 0,
    [](RelevoScene& s) { s.Add(Sphere(24, 20), MakeRecipe(2))->GetProperty()->SetOpacity(0.5); });
}

Mesh WithVectors(Mesh mesh)
{
  vtkNew<vtkFloatArray> vectors;
  vectors->SetName("Vectors");
  vectors->SetNumberOfComponents(4);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    vectors->InsertNextTuple4(i % 3, i % 5, i % 2, i % 4);
  }
  mesh->GetPointData()->SetScalars(vectors);
  return mesh;
}

// VTK draws these actors as opaque, although surfaces behind them are visible. The picture depends
// on the order of the faces, which is the mesh's if the CPU selects.
void TestTranslucentVectors(const Tester& tester)
{
  if (RelevoScene::GetSelectionDevice() != vtkAdaptiveRefinementMapper::SELECTION_DEVICE_GPU)
  {
    tester.Compare("TranslucentVectors", 0,
      [](RelevoScene& s)
      {
        vtkNew<vtkLookupTable> table;
        table->SetVectorModeToRGBColors();
        table->SetTableRange(0.0, 4.0);
        vtkMapper* mapper = s.Add(WithVectors(Sphere(24, 20)))->GetMapper();
        mapper->SetLookupTable(table);
        mapper->UseLookupTableScalarRangeOn();
        mapper->SetScalarModeToUsePointFieldData();
        mapper->ColorByArrayComponent("Vectors", -1);
      });
  }
}

// Back faces of these are visible, too.
void TestBacksSeen(const Tester& tester)
{
  tester.Compare("Clipped", 0,
    [](RelevoScene& s)
    {
      vtkActor* actor = s.Add(Sphere(24, 20), MakeRecipe(2));
      vtkNew<vtkPlane> plane;
      plane->SetNormal(0.3, 0.2, -1.0);
      actor->GetMapper()->AddClippingPlane(plane);
    });
  tester.Compare("Wireframe", 0,
    [](RelevoScene& s)
    { s.Add(Sphere(24, 20), MakeRecipe(2))->GetProperty()->SetRepresentationToWireframe(); });
  tester.Compare("Inside", 0,
    [](RelevoScene& s)
    {
      s.Add(Sphere(24, 20), MakeRecipe(2));
      s.MoveCamera = [](vtkCamera* camera) { camera->SetPosition(0.05, 0.03, 0.1); };
    });
}

void TestMirrored(const Tester& tester)
{
  tester.Compare("Mirrored", 0,
    [](RelevoScene& s)
    {
      vtkActor* actor = s.Add(Sphere(24, 20), MakeRecipe(2));
      actor->SetScale(-1, 1, 1);
      actor->GetProperty()->BackfaceCullingOn();
    });
}

// Faces out of view can cast shadows: the light has another camera.
void TestShadows(const Tester& tester)
{
  tester.Compare("Shadows", 30,
    [](RelevoScene& s)
    {
      s.Add(Sphere(24, 20), MakeRecipe(2))->SetPosition(1, 1, 2);
      s.Add(Plane(10, 10), MakeRecipe(2))->SetScale(6);
      Shade(s.Renderer);
    });
}
}

int TestAdaptiveRefinementMapperCulling(int argc, char* argv[])
{
  RelevoCheck check;
  RelevoComparison comparison(check, argc, argv);
  const Tester tester{ check, comparison };
  TestOpened(tester);
  TestBacksHidden(tester);
  TestTranslucent(tester);
  TestTranslucentVectors(tester);
  TestBacksSeen(tester);
  TestMirrored(tester);
  TestShadows(tester);
  return check.GetResult();
}
