// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Leaving out faces that cannot be seen changes no picture, in any pass.
#include "RelevoScene.h"
#include "RelevoTestMeshes.h"

#include "vtkCameraPass.h"
#include "vtkDisplacement.h"
#include "vtkLight.h"
#include "vtkOpaquePass.h"
#include "vtkOpenGLRenderer.h"
#include "vtkPNTriangleSurface.h"
#include "vtkPlane.h"
#include "vtkRenderPassCollection.h"
#include "vtkReverseSense.h"
#include "vtkSequencePass.h"
#include "vtkShadowMapBakerPass.h"
#include "vtkShadowMapPass.h"

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
}

int TestAdaptiveRefinementMapperCulling(int argc, char* argv[])
{
  RelevoCheck check;
  RelevoComparison comparison(check, argc, argv);
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
