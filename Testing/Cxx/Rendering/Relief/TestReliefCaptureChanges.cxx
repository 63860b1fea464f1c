// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkReliefCapture promises to capture again exactly when something visible has changed.
#include "RelevoCaptureScene.h"

#include "vtkAssembly.h"
#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkSphereSource.h"

#include <functional>
#include <string>

namespace
{
// Number of executions since the last call.
class Executions
{
public:
  explicit Executions(vtkReliefCapture* source)
    : Source(source)
  {
    this->Command->SetClientData(this);
    this->Command->SetCallback([](vtkObject*, unsigned long, void* self, void*)
      { ++static_cast<Executions*>(self)->Number; });
    source->AddObserver(vtkCommand::EndEvent, this->Command);
  }

  int Count()
  {
    this->Number = 0;
    this->Source->Update();
    return this->Number;
  }

private:
  vtkReliefCapture* Source;
  vtkNew<vtkCallbackCommand> Command;
  int Number = 0;
};

void TestChanges(RelevoCheck& check)
{
  RelevoCaptureScene scene;
  scene.Source->SetResolution(32);
  vtkActor* actor = scene.Add(RelevoBumpyBall(20));
  vtkActor* other = scene.Add(RelevoBumpyBall(10));
  vtkNew<vtkSphereSource> sphere;
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(sphere->GetOutputPort());
  other->SetMapper(mapper);
  other->SetPosition(1.0, 1.0, 0.0);
  scene.ResetCamera();
  vtkNew<vtkCamera> camera;
  camera->DeepCopy(scene.GetCamera());
  Executions executions(scene.Source);
  CHECK_EQUAL(executions.Count(), 1);
  CHECK_EQUAL(executions.Count(), 0);

  const auto step = [&](const std::string& name, int expected, const std::function<void()>& change)
  {
    change();
    const int first = executions.Count();
    scene.Window->Render();
    const int second = executions.Count();
    if (first != expected || second != 0)
    {
      check.Fail(__FILE__, __LINE__,
        name + ": executed " + std::to_string(first) + " and after a frame " +
          std::to_string(second) + " times");
    }
  };
  step("nothing", 0, []() {});
  step("view", 0, [&]() { scene.GetCamera()->Azimuth(20.0); });
  step("colour", 1, [&]() { actor->GetProperty()->SetColor(0.1, 0.9, 0.2); });
  step("place", 1, [&]() { actor->SetPosition(0.1, 0.0, 0.0); });
  step("data", 1, [&]() { sphere->SetRadius(0.7); });
  step("hidden", 1, [&]() { other->VisibilityOff(); });
  step("data of what is hidden", 0, [&]() { sphere->SetRadius(0.8); });
  step("shown", 1, [&]() { other->VisibilityOn(); });
  step("removed", 1, [&]() { scene.Renderer->RemoveActor(other); });
  auto* light = vtkLight::SafeDownCast(scene.Renderer->GetLights()->GetItemAsObject(0));
  step("light's place", 1, [&]() { light->SetPosition(0.0, 9.0, 1.0); });
  step("light's colour", 1, [&]() { light->SetDiffuseColor(0.3, 0.4, 0.5); });
  step("another light", 1,
    [&]()
    {
      vtkNew<vtkLight> headlight;
      headlight->SetLightTypeToHeadlight();
      scene.Renderer->AddLight(headlight);
    });
  step("view with a headlight", 0, [&]() { scene.GetCamera()->Azimuth(20.0); });
  step("camera", 1, [&]() { scene.Source->AddCamera(camera); });
  step("camera's place", 1, [&]() { camera->Azimuth(5.0); });
  step("resolution", 1, [&]() { scene.Source->SetResolution(16); });
  step("same resolution", 0, [&]() { scene.Source->SetResolution(16, 16); });
}

// Drawing an assembly moves its parts, which is not a change.
void TestAssembly(RelevoCheck& check)
{
  RelevoCaptureScene scene;
  scene.Source->SetResolution(32);
  vtkNew<vtkSphereSource> sphere;
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(sphere->GetOutputPort());
  vtkNew<vtkActor> part;
  part->SetMapper(mapper);
  vtkNew<vtkAssembly> assembly;
  assembly->AddPart(part);
  assembly->SetPosition(1.0, 0.0, 0.0);
  scene.Renderer->AddActor(assembly);
  scene.ResetCamera();
  Executions executions(scene.Source);
  const std::function<void()> changes[] = { [&]() { part->GetProperty()->SetColor(1.0, 0.0, 0.0); },
    [&]() { part->SetPosition(0.0, 1.0, 0.0); }, [&]() { assembly->RotateX(20.0); },
    [&]() { sphere->SetRadius(0.7); },
    [&]() { assembly->AddPart(scene.Add(RelevoBumpyBall(8))); } };
  CHECK_EQUAL(executions.Count(), 1);
  for (const auto& change : changes)
  {
    scene.Window->Render();
    scene.Renderer->ComputeVisiblePropBounds();
    CHECK_EQUAL(executions.Count(), 0);
    change();
    CHECK_EQUAL(executions.Count(), 1);
    CHECK_EQUAL(executions.Count(), 0);
  }
}

// Captures use the headlight that a renderer creates in its first frame.
void TestOwnLight(RelevoCheck& check)
{
  RelevoCaptureScene scene;
  scene.Renderer->RemoveAllLights();
  scene.Source->SetResolution(32);
  scene.Add(RelevoBumpyBall(20));
  Executions executions(scene.Source);
  CHECK_EQUAL(executions.Count(), 1);
  scene.Window->Render();
  CHECK_EQUAL(executions.Count(), 0);
}
}

int TestReliefCaptureChanges(int, char*[])
{
  RelevoCheck check;
  TestChanges(check);
  TestAssembly(check);
  TestOwnLight(check);
  return check.GetResult();
}
