// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves that mappers, recipes and windows delete all their OpenGL objects, in every order of
// deletion. RELEVO_TEST_ROUNDS=500 repeats this and prints the memory in use.
#include "RelevoDisplacements.h"
#include "RelevoMethods.h"
#include "RelevoScene.h"
#include "RelevoTestMeshes.h"

#include "OpenGL/RelevoOpenGL.h"
#include "vtkPNTriangleSurface.h"
#include "vtkProperty.h"

#include <algorithm>
#include <iostream>
#include <malloc.h>
#include <map>

namespace
{
using namespace RelevoMeshes;
using Mapper = vtkAdaptiveRefinementMapper;

// Numbers of objects of each kind in the current context, as OpenGL reports them.
std::map<std::string, int> CountObjects()
{
  std::map<std::string, int> counts;
  for (GLuint id = 1; id < 10000; ++id)
  {
    counts["buffers"] += glIsBuffer(id);
    counts["textures"] += glIsTexture(id);
    counts["vertex arrays"] += glIsVertexArray(id);
    counts["framebuffers"] += glIsFramebuffer(id);
    counts["renderbuffers"] += glIsRenderbuffer(id);
    counts["queries"] += glIsQuery(id);
    counts["programs"] += glIsProgram(id);
    counts["shaders"] += glIsShader(id);
  }
  return counts;
}

vtkSmartPointer<vtkAdaptiveRefinement> MakeDisplacedRecipe()
{
  vtkNew<RelevoHeights> heights;
  heights->FillRandom(8, 8, 1);
  auto displacement = MakeDisplacement(heights, 0.1);
  vtkNew<vtkPNTriangleSurface> surface;
  vtkNew<vtkAdaptiveRefinement> recipe;
  recipe->SetMaximumLevel(2);
  recipe->SetSurface(surface);
  recipe->SetDisplacement(displacement);
  return recipe.Get();
}

// A mapper is created, changed while it is shown, and deleted before its actor, after it, or while
// it is shared.
void DrawMapper(RelevoScene& scene, int method, int device, int round)
{
  Mesh mesh = TexturedSphere(8, 6);
  auto mapper = vtk::TakeSmartPointer(RelevoScene::NewMapper(mesh));
  mapper->SetInputDataObject(mesh);
  mapper->SetMethod(method);
  mapper->SetSelectionDevice(device);
  mapper->SetRefinement(MakeDisplacedRecipe());
  vtkNew<vtkActor> actors[2];
  for (int i = 0; i < 2; ++i)
  {
    actors[i]->SetMapper(mapper);
    actors[i]->GetProperty()->SetRepresentation(i == 0 ? VTK_SURFACE : VTK_WIREFRAME);
    scene.Renderer->AddActor(actors[i]);
  }
  scene.Renderer->ResetCamera();
  scene.Window->Render();
  mapper->SetRefinement(MakeDisplacedRecipe());
  mapper->SetColorModeToLevel();
  scene.Window->Render();
  mapper->SetMethodToARKFPI();
  scene.Window->Render();
  if (round % 3 == 0)
  {
    actors[0]->SetMapper(nullptr); // the other actor uses it
    actors[1]->SetMapper(nullptr);
    mapper = nullptr;
  }
  else if (round % 3 == 1)
  {
    scene.Window->Render();
    mapper->ReleaseGraphicsResources(scene.Window);
  }
  scene.Renderer->RemoveActor(actors[0]);
  scene.Renderer->RemoveActor(actors[1]);
}

// A window that shares its objects with another is created and deleted, before its contents or
// after.
void DrawWindow(RelevoScene& scene, int method, int round)
{
  Mesh mesh = TexturedSphere(8, 6);
  auto mapper = vtk::TakeSmartPointer(RelevoScene::NewMapper(mesh));
  mapper->SetInputDataObject(mesh);
  mapper->SetMethod(method);
  mapper->SetRefinement(MakeDisplacedRecipe());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  vtkNew<vtkRenderer> renderer;
  renderer->AddActor(actor);
  vtkSmartPointer<vtkRenderWindow> window = vtkSmartPointer<vtkRenderWindow>::New();
  window->SetSize(60, 60);
  window->SetSharedRenderWindow(scene.Window);
  window->AddRenderer(renderer);
  window->Render();
  if (round % 2 == 0)
  {
    scene.Renderer->AddActor(actor); // the mapper moves to the other window
    scene.Window->Render();
    window->Render();
    scene.Window->Render();
    scene.Renderer->RemoveActor(actor);
  }
  else
  {
    actor->SetMapper(nullptr);
    mapper = nullptr;
  }
  if (round % 3 != 0)
  {
    window->RemoveRenderer(renderer);
  }
  window = nullptr;
}
}

int TestAdaptiveRefinementMapperObjects(int, char*[])
{
  RelevoCheck check;
  RelevoScene scene(RelevoScene::Refining);
  scene.Window->SetSize(60, 60);
  scene.Window->Render();
  const char* wanted = std::getenv("RELEVO_TEST_ROUNDS");
  const int rounds = wanted ? std::max(std::atoi(wanted), 12) : 12;
  std::vector<int> methods = RelevoMethods::GetMethods();
  methods.push_back(Mapper::METHOD_HARDWARE_TESSELLATION);
  std::map<std::string, int> before;
  for (int round = 0; round < rounds; ++round)
  {
    if (round % 6 == 0)
    {
      scene.Window->MakeCurrent();
      const std::map<std::string, int> counts = CountObjects();
      std::cout << "round " << round << ", " << mallinfo2().uordblks << " bytes:";
      for (const auto& count : counts)
      {
        std::cout << " " << count.second << " " << count.first;
      }
      std::cout << std::endl;
      // From the seventh round on, VTK has cached all programs.
      if (round > 6)
      {
        CHECK_EQUAL(counts, before);
      }
      before = counts;
    }
    const int method = methods[round % methods.size()];
    DrawMapper(scene, method, Mapper::SELECTION_DEVICE_CPU, round);
    DrawMapper(scene, method, Mapper::SELECTION_DEVICE_GPU, round + 1);
    DrawWindow(scene, method, round);
  }
  scene.Window->MakeCurrent();
  CHECK_EQUAL(CountObjects(), before);
  return check.GetResult();
}
