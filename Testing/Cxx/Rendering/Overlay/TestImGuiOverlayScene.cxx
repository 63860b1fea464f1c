// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Frames that only the panels need repeat the scene, with the same pixels and depths as if it were
// drawn. Any change of the scene draws it.
#include "OverlayStage.h"
#include "RelevoPictures.h"

#include "vtkActor2D.h"
#include "vtkHardwareSelector.h"
#include "vtkPolyDataMapper2D.h"
#include "vtkSelection.h"
#include "vtkWindowToImageFilter.h"

namespace
{
// The window shows what a frame with the scene shows.
void TestPicture(RelevoCheck& check, OverlayStage& stage)
{
  const RelevoPicture shown(stage.Window);
  stage.Overlay->RepeatsSceneOff();
  const int frames = stage.SceneFrames;
  stage.Window->Render();
  CHECK_EQUAL(stage.SceneFrames, frames + 1);
  CHECK(RelevoPictures::Equal(RelevoPicture(stage.Window), shown));
  stage.Overlay->RepeatsSceneOn();
  stage.Window->Render();
}

void TestPanels(RelevoCheck& check, int multiSamples)
{
  CHECK_CASE(multiSamples);
  OverlayStage stage(multiSamples);
  stage.Window->Render();
  const int scenes = stage.SceneFrames;
  const int frames = stage.Frames;
  stage.Drag(30, stage.SliderY, 110, stage.SliderY);
  CHECK_GREATER(stage.Frames, frames + 4);
  CHECK_EQUAL(stage.SceneFrames, scenes);
  CHECK_EQUAL(stage.Overlay->GetNumberOfRepeatedFrames(), stage.Frames - frames);
  CHECK(stage.Renderer->GetDraw());
  TestPicture(check, stage);

  // Without an event.
  const int before = stage.SceneFrames;
  stage.Value = 0.25f;
  CHECK(stage.Overlay->Refresh());
  CHECK(!stage.Overlay->Refresh());
  CHECK_EQUAL(stage.SceneFrames, before);
  TestPicture(check, stage);

  // A panel that closes uncovers the scene, and one that opens covers it.
  for (const bool hasPanel : { false, true })
  {
    const int drawn = stage.SceneFrames;
    stage.HasPanel = hasPanel;
    stage.Send(vtkCommand::MouseMoveEvent, hasPanel ? 70 : 71, 70);
    CHECK_EQUAL(stage.SceneFrames, drawn);
    TestPicture(check, stage);
  }
}

void TestChanges(RelevoCheck& check)
{
  OverlayStage stage;
  stage.Window->Render();
  // Moves the mouse over the slider and away, which changes the panel.
  bool isOver = false;
  const auto change = [&]
  {
    isOver = !isOver;
    stage.Send(vtkCommand::MouseMoveEvent, isOver ? 60 : 75, isOver ? stage.SliderY : 95);
  };
  const auto isDrawn = [&](const std::function<void()>& make)
  {
    const int before = stage.SceneFrames;
    make();
    change();
    return stage.SceneFrames > before;
  };
  change();
  CHECK(!isDrawn([] {}));
  CHECK(isDrawn([&] { stage.Actor->GetProperty()->SetColor(1.0, 0.0, 0.0); }));
  CHECK(!isDrawn([] {}));
  CHECK(isDrawn([&] { stage.Renderer->GetActiveCamera()->Azimuth(10.0); }));
  CHECK(isDrawn([&] { stage.Renderer->SetBackground(0.5, 0.5, 0.5); }));
  CHECK(isDrawn([&] { stage.Overlay->RequestFrame(); }));
  CHECK(!isDrawn([] {}));
  CHECK(isDrawn([&] { stage.Window->Render(); }));
  CHECK(!isDrawn([] {}));
  vtkNew<vtkSphereSource> flat;
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputConnection(flat->GetOutputPort());
  vtkNew<vtkActor2D> shape;
  shape->SetMapper(mapper);
  CHECK(isDrawn([&] { stage.Renderer->AddViewProp(shape); }));
  CHECK(isDrawn([&] { flat->SetRadius(90.0); }));
  CHECK(isDrawn([&] { stage.Actor->VisibilityOff(); }));
  CHECK(isDrawn([&] { stage.Actor->VisibilityOn(); }));
  vtkNew<vtkSphereSource> sphere;
  stage.Actor->GetMapper()->SetInputConnection(sphere->GetOutputPort());
  stage.Window->Render();
  CHECK(isDrawn([&] { sphere->SetRadius(0.4); }));
  CHECK(!isDrawn([] {}));
  TestPicture(check, stage);

  // Pixels that others draw into the window are not repeated.
  CHECK(isDrawn(
    [&]
    {
      vtkNew<vtkHardwareSelector> selector;
      selector->SetRenderer(stage.Renderer);
      selector->SetArea(0, 0, 100, 100);
      vtk::TakeSmartPointer(selector->Select());
    }));
  CHECK(isDrawn(
    [&]
    {
      vtkNew<vtkWindowToImageFilter> filter;
      filter->SetInput(stage.Window);
      filter->SetScale(2);
      filter->Update();
    }));
  CHECK(isDrawn([&] { stage.Window->SetSize(OverlayStage::Width, OverlayStage::Height - 20); }));
  stage.Window->SetSize(OverlayStage::Width, OverlayStage::Height);
  stage.Window->Render();
  CHECK(!isDrawn([] {}));
  TestPicture(check, stage);
}

// The slider changes the scene, and a drag beside the panel moves the camera.
void TestEvents(RelevoCheck& check)
{
  OverlayStage stage;
  stage.IsColored = true;
  stage.Window->Render();
  int before = stage.SceneFrames;
  stage.Drag(30, stage.SliderY, 110, stage.SliderY);
  CHECK_GREATER(stage.SceneFrames, before + 4);
  TestPicture(check, stage);
  before = stage.SceneFrames;
  stage.Drag(200, 150, 180, 120);
  CHECK_GREATER(stage.SceneFrames, before + 4);
  TestPicture(check, stage);
}

// Two overlays in a window do not repeat the panels of each other.
void TestTwoOverlays(RelevoCheck& check)
{
  OverlayStage stage;
  vtkNew<vtkImGuiOverlay> second;
  second->SetRenderWindow(stage.Window);
  second->SetCallback(
    []
    {
      ImGui::Begin("second");
      ImGui::End();
    });
  stage.Window->Render();
  stage.Send(vtkCommand::MouseMoveEvent, 60, stage.SliderY);
  CHECK_EQUAL(stage.Overlay->GetNumberOfRepeatedFrames(), 0);
  CHECK_EQUAL(second->GetNumberOfRepeatedFrames(), 0);
}
}

int TestImGuiOverlayScene(int, char*[])
{
  RelevoCheck check;
  TestPanels(check, 0);
  TestPanels(check, 4);
  TestChanges(check);
  TestEvents(check);
  TestTwoOverlays(check);
  return check.GetResult();
}
