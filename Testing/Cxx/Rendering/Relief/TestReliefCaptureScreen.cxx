// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkReliefCapture promises not to change the window's picture, its cameras or the mappers'
// buffers.
#include "RelevoCaptureScene.h"
#include "RelevoPictures.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRendererCollection.h"
#include "vtkSphereSource.h"

namespace
{
// Counts its buffer builds.
class CountingMapper : public vtkOpenGLPolyDataMapper
{
public:
  static CountingMapper* New();
  vtkTypeMacro(CountingMapper, vtkOpenGLPolyDataMapper);
  int NumberOfBuilds = 0;

protected:
  void BuildBufferObjects(vtkRenderer* renderer, vtkActor* actor) override
  {
    ++this->NumberOfBuilds;
    this->Superclass::BuildBufferObjects(renderer, actor);
  }
};
vtkStandardNewMacro(CountingMapper);

// Two renderers side by side, the left one with a layer above it.
struct Stage : RelevoCaptureScene
{
  explicit Stage(int multiSamples, bool offScreen)
  {
    this->Window->SetMultiSamples(multiSamples);
    this->Window->SetOffScreenRendering(offScreen);
    this->Window->SetNumberOfLayers(2);
    this->Renderer->SetViewport(0.0, 0.0, 0.6, 1.0);
    this->Other->SetViewport(0.6, 0.1, 1.0, 0.9);
    this->Above->SetViewport(0.0, 0.0, 0.6, 1.0);
    this->Above->SetLayer(1);
    vtkActor* ball = this->Add(RelevoBumpyBall());
    this->Mapper->SetInputDataObject(ball->GetMapper()->GetInputDataObject(0, 0));
    ball->SetMapper(this->Mapper);
    vtkActor* pane = this->Add(RelevoBumpyBall(20));
    pane->SetPosition(0.5, 0.0, 1.0);
    pane->GetProperty()->SetOpacity(0.4);
    this->Other->AddActor(ball); // belongs to both renderers
    this->Window->AddRenderer(this->Other);
    vtkNew<vtkSphereSource> small;
    small->SetRadius(0.1);
    vtkNew<vtkOpenGLPolyDataMapper> mapper;
    mapper->SetInputConnection(small->GetOutputPort());
    vtkNew<vtkActor> dot;
    dot->SetMapper(mapper);
    this->Above->AddActor(dot);
    this->Window->AddRenderer(this->Above);
    this->ResetCamera();
    for (vtkRenderer* renderer : { this->Other.Get(), this->Above.Get() })
    {
      renderer->GetActiveCamera()->DeepCopy(this->GetCamera());
      renderer->ResetCameraClippingRange();
    }
  }

  vtkNew<vtkRenderer> Other;
  vtkNew<vtkRenderer> Above;
  vtkNew<CountingMapper> Mapper;
};

void TestKept(RelevoCheck& check, int multiSamples, bool offScreen)
{
  Stage stage(multiSamples, offScreen);
  RelevoErrors warnings(stage.Source); // warnings about translucent props
  stage.Window->Render();
  stage.Window->Render(); // the first frame resets cameras
  const RelevoPicture before(stage.Window);
  CHECK_GREATER(before.CountForeground(), 3000);
  vtkCamera* camera = stage.GetCamera();
  const vtkMTimeType cameraTime = camera->GetMTime();
  const vtkMTimeType rendererTime = stage.Renderer->GetMTime();
  const int builds = stage.Mapper->NumberOfBuilds;
  const int numberOfRenderers = stage.Window->GetRenderers()->GetNumberOfItems();
  double range[2];
  camera->GetClippingRange(range);

  stage.Source->SetResolution(333, 250);
  CHECK_NOT_EQUAL(stage.Capture(), nullptr);
  CHECK_EQUAL(stage.Source->GetOutput()->GetNumberOfBlocks(), 6);
  CHECK(warnings.Warned("translucent"));

  CHECK_EQUAL(stage.GetCamera(), camera);
  CHECK_EQUAL(camera->GetMTime(), cameraTime);
  CHECK_EQUAL(stage.Renderer->GetMTime(), rendererTime);
  CHECK(camera->GetClippingRange()[0] == range[0] && camera->GetClippingRange()[1] == range[1]);
  CHECK_EQUAL(stage.Window->GetRenderers()->GetNumberOfItems(), numberOfRenderers);
  CHECK(stage.Window->GetSize()[0] == 200 && stage.Window->GetSize()[1] == 150);
  CHECK_EQUAL(stage.Mapper->NumberOfBuilds, builds);
  CHECK(RelevoPictures::Equal(RelevoPicture(stage.Window), before)); // without a frame
  stage.Window->Render();
  CHECK(RelevoPictures::Equal(RelevoPicture(stage.Window), before));
  CHECK_EQUAL(stage.Mapper->NumberOfBuilds, builds);
}

// Captures during a frame.
void TestInsideFrame(RelevoCheck& check)
{
  Stage stage(0, false);
  RelevoErrors warnings(stage.Source);
  stage.Window->Render();
  stage.Window->Render();
  const RelevoPicture before(stage.Window);
  int number = 0;
  auto capture = [&]()
  {
    stage.Source->Modified();
    number += stage.Capture() ? 1 : 0;
  };
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(&capture);
  command->SetCallback([](vtkObject*, unsigned long, void* data, void*)
    { (*static_cast<decltype(capture)*>(data))(); });
  stage.Renderer->AddObserver(vtkCommand::StartEvent, command);
  stage.Renderer->AddObserver(vtkCommand::EndEvent, command);
  stage.Above->AddObserver(vtkCommand::StartEvent, command);
  stage.Window->Render();
  CHECK_EQUAL(number, 3);
  CHECK(RelevoPictures::Equal(RelevoPicture(stage.Window), before));
}

// A window that was never drawn is initialized, and afterwards behaves like any other.
void TestFirst(RelevoCheck& check)
{
  const auto draw = [&](bool captures)
  {
    Stage stage(0, false);
    RelevoErrors warnings(stage.Source);
    CHECK(!captures || stage.Capture() != nullptr);
    stage.Window->Render();
    stage.Window->Render();
    return RelevoPicture(stage.Window);
  };
  CHECK(RelevoPictures::Equal(draw(true), draw(false)));
}

// The captures' cameras carry copies of the headlights.
void TestLights(RelevoCheck& check)
{
  RelevoCaptureScene scene;
  scene.Renderer->RemoveAllLights();
  scene.Add(RelevoBumpyBall());
  scene.ResetCamera();
  scene.Window->Render();
  auto* light = vtkLight::SafeDownCast(scene.Renderer->GetLights()->GetItemAsObject(0));
  const vtkMTimeType time = light->GetMTime();
  CHECK_NOT_EQUAL(scene.Capture(), nullptr);
  CHECK_EQUAL(light->GetMTime(), time);
}
}

int TestReliefCaptureScreen(int, char*[])
{
  RelevoCheck check;
  TestKept(check, 0, false);
  TestKept(check, 8, false);
  TestKept(check, 0, true);
  TestKept(check, 4, true);
  TestInsideFrame(check);
  TestFirst(check);
  TestLights(check);
  return check.GetResult();
}
