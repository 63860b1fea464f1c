// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Leaving out faces that cannot be seen changes no picture, in any pass.
#include "RelevoScene.h"
#include "RelevoTestMeshes.h"

#include "vtkCameraPass.h"
#include "vtkDisplacement.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkLookupTable.h"
#include "vtkOpaquePass.h"
#include "vtkOpenGLRenderer.h"
#include "vtkPNTriangleSurface.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderPassCollection.h"
#include "vtkReverseSense.h"
#include "vtkSequencePass.h"
#include "vtkShaderProperty.h"
#include "vtkShadowMapBakerPass.h"
#include "vtkShadowMapPass.h"
#include "vtkTexture.h"
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
  vtkNew<vtkShadowMapBakerPass> baker;
  vtkNew<vtkShadowMapPass> shadows;
  shadows->SetShadowMapBakerPass(baker);
  vtkNew<vtkRenderPassCollection> passes;
  passes->AddItem(baker);
  passes->AddItem(shadows);
  vtkNew<vtkSequencePass> sequence;
  sequence->SetPasses(passes);
  vtkNew<vtkCameraPass> cameraPass;
  cameraPass->SetDelegatePass(sequence);
  vtkOpenGLRenderer::SafeDownCast(renderer)->SetPass(cameraPass);
}

// Where a closed surface shows its inside, or what is drawn reaches beyond the points of faces:
// against vtkPolyDataMapper, which leaves nothing out.
void TestOpened(RelevoCheck& check, RelevoComparison& comparison)
{
  vtkNew<vtkPNTriangleSurface> curved;
  const auto compare = [&](const std::string& name, size_t pixels, vtkAdaptiveRefinement* recipe,
                         const RelevoComparison::Builder& change)
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
    comparison.Compare("Culling." + name + (recipe ? ".Curved" : ""), tolerance,
      RelevoPicture(refining.Window), RelevoPicture(twin.Window));
    return refining.GetMapper(0)->GetNumberOfCulledFaces();
  };
  constexpr size_t outline = 12;
  for (const auto& recipe : { vtkSmartPointer<vtkAdaptiveRefinement>(), MakeRecipe(3, curved) })
  {
    const auto getCamera = [](RelevoScene& s) { return s.Renderer->GetActiveCamera(); };
    const vtkIdType hidden = compare("Uncut", outline, recipe, [](RelevoScene&) {});
    CHECK(hidden > 100);
    for (double nearPlane : { 1.8, 2.1, 2.5 })
    {
      const std::string name = "Near." + std::to_string(nearPlane);
      const vtkIdType cut = compare(name, outline, recipe,
        [&](RelevoScene& s) { getCamera(s)->SetClippingRange(nearPlane, 10.0); });
      CHECK(cut == 0);
      compare(name + ".Parallel", outline, recipe,
        [&](RelevoScene& s)
        {
          getCamera(s)->SetClippingRange(nearPlane, 10.0);
          getCamera(s)->ParallelProjectionOn();
        });
    }
    compare("CutOut", outline, recipe,
      [](RelevoScene& s)
      {
        vtkNew<vtkImageData> image;
        image->SetDimensions(8, 8, 1);
        image->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
        auto* texel = static_cast<unsigned char*>(image->GetScalarPointer());
        for (int i = 0; i < 256; ++i)
        {
          texel[i] = static_cast<unsigned char>(i % 4 < 3 ? 200 : 255 * (i / 4 % 2));
        }
        vtkNew<vtkTexture> texture;
        texture->SetInputData(image);
        s.GetActor(0)->SetTexture(texture);
      });
    compare("Discarded", outline, recipe,
      [](RelevoScene& s)
      {
        s.GetActor(0)->GetShaderProperty()->AddFragmentShaderReplacement("//VTK::Light::Impl", true,
          "//VTK::Light::Impl\n  if (mod(gl_FragCoord.x, 16.0) < 8.0 && gl_FrontFacing) discard;\n",
          false);
      });
    compare("ForcedOpaque", outline, recipe,
      [](RelevoScene& s)
      {
        s.GetActor(0)->ForceOpaqueOn();
        s.GetActor(0)->GetProperty()->SetOpacity(0.999);
      });
    for (bool parallel : { false, true })
    {
      compare(parallel ? "Sheared.Parallel" : "Sheared", outline, recipe,
        [&](RelevoScene& s)
        {
          vtkNew<vtkTransform> transform;
          transform->Translate(0.6, -0.4, 0.7);
          transform->RotateY(25.0);
          getCamera(s)->SetUserViewTransform(transform);
          getCamera(s)->SetViewShear(0.4, 0.3, 1.0);
          getCamera(s)->SetParallelProjection(parallel);
        });
    }
  }
  compare("MovedVertices", 0, nullptr,
    [](RelevoScene& s)
    {
      // Mostly out of sight as it is, in sight by the actor's shader.
      s.Renderer->GetActiveCamera()->SetViewAngle(20.0);
      s.GetActor(0)->SetPosition(-0.7, 0.0, 0.0);
      s.GetActor(0)->GetShaderProperty()->AddVertexShaderReplacement("//VTK::Normal::Impl", true,
        "//VTK::Normal::Impl\n  vec4 aside = vertexMC + vec4(0.7, 0.0, 0.0, 0.0);\n", false);
      s.GetActor(0)->GetShaderProperty()->AddVertexShaderReplacement("//VTK::PositionVC::Impl",
        true, "//VTK::PositionVC::Impl\n  gl_Position = MCDCMatrix * aside;\n", false);
    });
  for (int representation : { VTK_POINTS, VTK_WIREFRAME })
  {
    compare("Wide." + std::to_string(representation), 0, nullptr,
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
}

int TestAdaptiveRefinementMapperCulling(int argc, char* argv[])
{
  RelevoCheck check;
  RelevoComparison comparison(check, argc, argv);
  TestOpened(check, comparison);
  vtkNew<vtkPNTriangleSurface> curved;
  vtkNew<RelevoHeights> heights;
  heights->FillRandom(17, 13, 4);
  vtkNew<vtkDisplacement> up;
  up->SetHeightMap(heights);
  up->SetDirection(0, 0, 1);
  up->SetScale(0.5);

  // Builds a scene twice: with all faces drawn, and without those that cannot be seen.
  const auto compare = [&](const std::string& name, size_t pixels, bool expectCulled,
                         const RelevoComparison::Builder& build)
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
      culled.Renderer->GetActiveCamera()
        ->Modified(); // a copy alone is not drawn anew in all passes
      culled.Render();
      RelevoTolerance tolerance;
      tolerance.Pixels = pixels;
      comparison.Compare("Culling." + name + "." + std::to_string(closer), tolerance,
        RelevoPicture(culled.Window), RelevoPicture(all.Window));
      CHECK(culled.CountTriangles() == all.CountTriangles());
    }
    vtkIdType faces = 0;
    for (size_t i = 0; i < culled.GetNumberOfActors(); ++i)
    {
      faces += culled.GetMapper(i)->GetNumberOfCulledFaces();
      CHECK(all.GetMapper(i)->GetNumberOfCulledFaces() == 0);
    }
    CHECK((faces > 0) == expectCulled);
  };

  constexpr size_t outline = 4; // pixels where front and back are equally deep
  compare("Sphere", outline, true, [](RelevoScene& s) { s.Add(Sphere(24, 20), MakeRecipe(2)); });
  compare(
    "Curved", outline, true, [&](RelevoScene& s) { s.Add(Sphere(12, 10), MakeRecipe(4, curved)); });
  compare("Displaced", 0, true,
    [&](RelevoScene& s) { s.Add(Plane(12, 12), MakeRecipe(4, nullptr, up)); });
  compare("Parallel", outline, true,
    [](RelevoScene& s)
    {
      s.Add(Sphere(24, 20), MakeRecipe(2));
      s.Renderer->GetActiveCamera()->ParallelProjectionOn();
    });
  compare("InsideOut", 0, true,
    [](RelevoScene& s)
    {
      vtkNew<vtkReverseSense> reversed;
      reversed->SetInputData(Sphere(24, 20));
      reversed->ReverseCellsOn();
      reversed->Update();
      s.Add(reversed->GetOutput(), MakeRecipe(2));
    });
  compare("Moved", outline, true,
    [](RelevoScene& s)
    {
      const double far[3] = { 4e6, 5e6, -3e6 };
      vtkActor* actor = s.Add(Moved(Sphere(24, 20), 100.0, far, VTK_DOUBLE), MakeRecipe(2));
      actor->RotateY(30);
      actor->SetScale(1, 2, 0.7);
    });
  // The backs of these are to be seen.
  compare("Translucent", 0, true,
    [](RelevoScene& s) { s.Add(Sphere(24, 20), MakeRecipe(2))->GetProperty()->SetOpacity(0.5); });
  // VTK draws these with what is opaque, and yet there is something behind to be seen. They look by
  // the order that faces are drawn in: the mesh's, if the CPU selects.
  if (RelevoScene::GetSelectionDevice() != vtkAdaptiveRefinementMapper::SELECTION_DEVICE_GPU)
  {
    compare("TranslucentVectors", 0, true,
      [](RelevoScene& s)
      {
        Mesh mesh = Sphere(24, 20);
        vtkNew<vtkFloatArray> vectors;
        vectors->SetName("Vectors");
        vectors->SetNumberOfComponents(4);
        for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
        {
          vectors->InsertNextTuple4(i % 3, i % 5, i % 2, i % 4);
        }
        mesh->GetPointData()->SetScalars(vectors);
        vtkNew<vtkLookupTable> table;
        table->SetVectorModeToRGBColors();
        table->SetTableRange(0.0, 4.0);
        vtkMapper* mapper = s.Add(mesh)->GetMapper();
        mapper->SetLookupTable(table);
        mapper->UseLookupTableScalarRangeOn();
        mapper->SetScalarModeToUsePointFieldData();
        mapper->ColorByArrayComponent("Vectors", -1);
      });
  }
  compare("Clipped", 0, true,
    [](RelevoScene& s)
    {
      vtkActor* actor = s.Add(Sphere(24, 20), MakeRecipe(2));
      vtkNew<vtkPlane> plane;
      plane->SetNormal(0.3, 0.2, -1.0);
      actor->GetMapper()->AddClippingPlane(plane);
    });
  compare("Wireframe", 0, true,
    [](RelevoScene& s)
    { s.Add(Sphere(24, 20), MakeRecipe(2))->GetProperty()->SetRepresentationToWireframe(); });
  compare("Inside", 0, true,
    [](RelevoScene& s)
    {
      s.Add(Sphere(24, 20), MakeRecipe(2));
      s.MoveCamera = [](vtkCamera* camera) { camera->SetPosition(0.05, 0.03, 0.1); };
    });
  compare("Mirrored", 0, true,
    [](RelevoScene& s)
    {
      vtkActor* actor = s.Add(Sphere(24, 20), MakeRecipe(2));
      actor->SetScale(-1, 1, 1);
      actor->GetProperty()->BackfaceCullingOn();
    });
  // What the camera does not see can throw shadows: the light is a camera of its own.
  compare("Shadows", 30, true,
    [](RelevoScene& s)
    {
      s.Add(Sphere(24, 20), MakeRecipe(2))->SetPosition(1, 1, 2);
      s.Add(Plane(10, 10), MakeRecipe(2))->SetScale(6);
      Shade(s.Renderer);
    });
  return check.GetResult();
}
