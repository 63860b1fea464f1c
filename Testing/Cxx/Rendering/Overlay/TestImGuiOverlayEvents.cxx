// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Panels and the scene share mouse and keys, and nothing is drawn while nothing changes.
#include "OverlayStage.h"

#include "vtkActorCollection.h"
#include "vtkProperty.h"

#include <string>

namespace
{
bool IsWireframe(OverlayStage& stage)
{
  return stage.Renderer->GetActors()->GetLastActor()->GetProperty()->GetRepresentation() ==
    VTK_WIREFRAME;
}

void TestMouse(RelevoCheck& check)
{
  OverlayStage stage;
  stage.Window->Render();
  const double azimuth = stage.GetAzimuth();

  // A drag over the slider changes it in each frame, and not the camera.
  const int frames = stage.Frames;
  stage.Drag(30, stage.SliderY, 110, stage.SliderY);
  CHECK_GREATER(stage.Value, 0.7f);
  CHECK_GREATER(stage.Frames, frames + 4);
  CHECK_EQUAL(stage.GetAzimuth(), azimuth);

  // It continues outside of the panel.
  stage.Drag(110, stage.SliderY, 220, 150);
  CHECK_EQUAL(stage.Value, 1.0f);
  CHECK_EQUAL(stage.GetAzimuth(), azimuth);

  // A drag over the scene moves the camera, also when it reaches the panel.
  stage.Drag(200, 150, 60, stage.SliderY);
  CHECK_EQUAL(stage.Value, 1.0f);
  CHECK_GREATER(std::abs(stage.GetAzimuth() - azimuth), 0.01);

  // The panel works after that.
  stage.Click(20, stage.SliderY);
  CHECK_LESS(stage.Value, 0.1f);

  // The wheel zooms only over the scene.
  const double distance = stage.Renderer->GetActiveCamera()->GetDistance();
  stage.Send(vtkCommand::MouseWheelForwardEvent, 60, stage.SliderY);
  CHECK_EQUAL(stage.Renderer->GetActiveCamera()->GetDistance(), distance);
  stage.Send(vtkCommand::MouseWheelForwardEvent, 200, 150);
  CHECK_LESS(stage.Renderer->GetActiveCamera()->GetDistance(), distance);

  // Hidden panels take nothing.
  stage.Overlay->VisibilityOff();
  const double position = stage.GetAzimuth();
  stage.Drag(30, stage.SliderY, 110, stage.SliderY);
  CHECK_LESS(stage.Value, 0.1f);
  CHECK(stage.GetAzimuth() != position);
}

void TestKeys(RelevoCheck& check)
{
  OverlayStage stage;
  stage.Window->Render();
  stage.SendKey("w", 'w');
  CHECK(IsWireframe(stage));
  stage.SendKey("s", 's');
  CHECK(!IsWireframe(stage));

  // Text goes to the field that has the focus.
  stage.Click(60, stage.TextY);
  CHECK(stage.Overlay->GetCapturesKeyboard());
  for (const char* key : { "w", "5" })
  {
    stage.SendKey(key, key[0]);
  }
  stage.SendKey("Return", '\r');
  CHECK_EQUAL(std::string(stage.Text), std::string("w5"));
  CHECK(!IsWireframe(stage));

  // A click on the scene gives the keys back.
  stage.Click(200, 150);
  CHECK(!stage.Overlay->GetCapturesKeyboard());
  stage.SendKey("w", 'w');
  CHECK(IsWireframe(stage));
  CHECK_EQUAL(std::string(stage.Text), std::string("w5"));

  // Panels that were hidden do not take the keys when they reappear.
  stage.Overlay->VisibilityOff();
  stage.Window->Render();
  stage.Overlay->VisibilityOn();
  stage.Window->Render();
  stage.SendKey("s", 's');
  stage.SendKey("w", 'w');
  stage.SendKey("s", 's');
  CHECK(!IsWireframe(stage));
}

// By the arrows, Space and Escape.
void TestNavigation(RelevoCheck& check)
{
  OverlayStage stage;
  stage.Window->Render();
  stage.Click(60, 15); // the title
  stage.SendKey("Down", 0);
  stage.SendKey("Up", 0);
  stage.SendKey("space", ' ');
  for (int i = 0; i < 5; ++i)
  {
    stage.SendKey("Right", 0);
  }
  CHECK_GREATER(stage.Value, 0.0f);
}

void TestStill(RelevoCheck& check)
{
  OverlayStage stage;
  stage.Window->Render();
  stage.Send(vtkCommand::MouseMoveEvent, 60, stage.SliderY);
  const int frames = stage.Frames;
  for (int i = 0; i < 20; ++i)
  {
    stage.Send(vtkCommand::MouseMoveEvent, 60 + i, stage.SliderY); // highlighted already
    stage.SendKey("F5", 0);
    CHECK(!stage.Overlay->Update());
  }
  CHECK_EQUAL(stage.Frames, frames);
  stage.Send(vtkCommand::LeaveEvent, 0, 0); // not highlighted any more
  CHECK_EQUAL(stage.Frames, frames + 1);
  for (int i = 0; i < 20; ++i)
  {
    stage.Send(vtkCommand::MouseMoveEvent, 160 + i, 150);
  }
  CHECK_EQUAL(stage.Frames, frames + 1);
  stage.Overlay->RequestFrame();
  stage.Send(vtkCommand::MouseMoveEvent, 160, 150);
  CHECK_EQUAL(stage.Frames, frames + 2);
}
}

int TestImGuiOverlayEvents(int, char*[])
{
  RelevoCheck check;
  TestMouse(check);
  TestKeys(check);
  TestNavigation(check);
  TestStill(check);
  return check.GetResult();
}
