// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves reliefs.md: the pass captures again at the documented angles and shares of holes, and
// predicts holes as well as stated.
#include "RelevoPassScene.h"

#include "vtkActor2D.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkPolyDataMapper.h"
#include "vtkPolyDataMapper2D.h"
#include "vtkProperty.h"
#include "vtkSphereSource.h"

#include <functional>
#include <iostream>
#include <string>

namespace
{
void TestAngle(RelevoCheck& check)
{
  RelevoPassScene scene;
  scene.Wall->VisibilityOff(); // leaves no openings except those behind silhouettes
  scene.Pass->SetMaximumHoleShare(1.0);
  CHECK_EQUAL(scene.CountCaptures(), 1);
  CHECK_EQUAL(scene.CountCaptures(), 0);
  scene.GetCamera()->Azimuth(14.5);
  CHECK_EQUAL(scene.CountCaptures(), 0);
  scene.GetCamera()->Azimuth(1.5);
  CHECK_EQUAL(scene.CountCaptures(), 1);
  scene.GetCamera()->Azimuth(-1.5); // 14.5 from one and 1.5 from the other
  CHECK_EQUAL(scene.CountCaptures(), 0);
  scene.GetCamera()->Azimuth(-20.0);
  CHECK_EQUAL(scene.CountCaptures(), 0);
  scene.Pass->SetMaximumAngle(3.0);
  CHECK_EQUAL(scene.CountCaptures(), 1);
  scene.Pass->SetMaximumAngle(180.0);
  scene.GetCamera()->Elevation(60.0);
  CHECK_EQUAL(scene.CountCaptures(), 0);
}

void TestHoleShare(RelevoCheck& check)
{
  RelevoPassScene scene;
  CHECK_EQUAL(scene.CountCaptures(), 1);
  CHECK_LESS(scene.Pass->GetHoleShare(), 1e-3);
  // The pass captures again long before 15 degrees.
  double turned = 0.0;
  while (turned < 15.0 && scene.CountCaptures() == 0)
  {
    turned += 0.25;
    scene.GetCamera()->Azimuth(0.25);
  }
  std::cout << "captured again after " << turned << " degrees\n";
  CHECK_GREATER(turned, 0.5);
  CHECK_LESS(turned, 6.0);
  CHECK_LESS(scene.Pass->GetHoleShare(), 1e-3); // the share of the new capture
  // Returns to the view of the first capture.
  scene.GetCamera()->Azimuth(-turned);
  CHECK_EQUAL(scene.CountCaptures(), 0);
  // The share of holes stays below the limit.
  for (int i = 0; i < 12; ++i)
  {
    scene.GetCamera()->Azimuth(1.0);
    scene.GetCamera()->Elevation(0.5);
    scene.DrawMoving();
    CHECK_LESS_EQUAL(scene.Pass->GetHoleShare(), 0.005);
  }
}

// Compares prediction and measurement for one capture, from which the view turns away.
void TestPrediction(RelevoCheck& check, bool parallel)
{
  RelevoPassScene scene;
  scene.Window->SetSize(800, 600); // silhouettes are a small share
  scene.Pass->SetMaximumHoleShare(1.0);
  scene.Pass->SetMaximumAngle(180.0);
  scene.GetCamera()->SetParallelScale(3.5);
  scene.GetCamera()->SetParallelProjection(parallel);
  scene.DrawMoving();
  double last = 0.0;
  for (int i = 0; i < 6; ++i)
  {
    scene.GetCamera()->Azimuth(2.0);
    scene.GetCamera()->Elevation(1.0);
    const double actual = scene.FindHoles();
    const double predicted = scene.Pass->GetHoleShare();
    std::cout << "parallel " << parallel << ", step " << i << ": holes " << actual << ", predicted "
              << predicted << "\n";
    CHECK_GREATER(actual, 1e-4);
    CHECK_GREATER(predicted, 0.5 * actual);
    CHECK_LESS(predicted, 2.0 * actual + 0.001);
    CHECK_GREATER(predicted, last);
    last = predicted;
  }
  CHECK_EQUAL(scene.Pass->GetNumberOfCaptures(), 1);
}

// Two captures fill each other's openings.
void TestTogether(RelevoCheck& check)
{
  RelevoPassScene scene;
  scene.Window->SetSize(800, 600); // silhouettes are a small share
  scene.Pass->SetMaximumAngle(180.0);
  scene.Pass->SetMaximumHoleShare(1.0);
  scene.GetCamera()->Azimuth(-5.0);
  scene.DrawMoving();
  scene.GetCamera()->Azimuth(5.0);
  const double one = scene.FindHoles();
  const double predictedOfOne = scene.Pass->GetHoleShare();
  scene.Pass->SetMaximumAngle(4.0);
  scene.GetCamera()->Azimuth(5.0);
  CHECK_EQUAL(scene.CountCaptures(), 1);
  scene.Pass->SetMaximumAngle(180.0);
  scene.GetCamera()->Azimuth(-5.0);
  const double two = scene.FindHoles();
  const double predictedOfTwo = scene.Pass->GetHoleShare();
  std::cout << "one: " << one << ", predicted " << predictedOfOne << "; two: " << two
            << ", predicted " << predictedOfTwo << "\n";
  CHECK_LESS(two, 0.3 * one);
  CHECK_LESS(predictedOfTwo, 0.3 * predictedOfOne);
}

// An orbit around many balls in front of a wall, with a text that changes. Captures are made ahead
// of the motion, so that at least a third of the frames need none. If no holes are allowed,
// captures are hardly made.
void TestOrbit(RelevoCheck& check, double step, double share, int maximumCaptures, int minimumShown)
{
  RelevoPassScene scene;
  scene.Window->SetSize(300, 225);
  scene.Pass->SetMaximumHoleShare(share);
  vtkNew<vtkActor2D> text;
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData(vtkNew<vtkPolyData>());
  text->SetMapper(mapper);
  scene.Renderer->AddViewProp(text);
  int withoutCapture = 0;
  for (int i = 0; i < 30; ++i)
  {
    const vtkIdType captures = scene.Pass->GetNumberOfCaptures();
    const vtkIdType frames = scene.Pass->GetNumberOfReliefFrames();
    scene.DrawMoving();
    const bool isShown = scene.Pass->GetNumberOfReliefFrames() > frames;
    withoutCapture += isShown && scene.Pass->GetNumberOfCaptures() == captures;
    CHECK(!isShown || i == 0 || scene.Pass->GetHoleShare() <= share);
    CHECK_LESS_EQUAL(scene.Pass->GetNumberOfCaptures(), captures + 1);
    scene.GetCamera()->Azimuth(step);
    text->Modified();
  }
  std::cout << "orbit of " << step << " degrees, holes " << share << ": "
            << scene.Pass->GetNumberOfCaptures() << " captures, "
            << scene.Pass->GetNumberOfReliefFrames() << " frames of reliefs, " << withoutCapture
            << " of them without a capture\n";
  CHECK_LESS_EQUAL(scene.Pass->GetNumberOfCaptures(), maximumCaptures);
  CHECK_GREATER_EQUAL(withoutCapture, minimumShown);
}

// If the mesh changes in each frame, captures do not pay off.
void TestAnimation(RelevoCheck& check)
{
  RelevoPassScene scene;
  scene.Window->SetSize(100, 75);
  for (int i = 0; i < 40; ++i)
  {
    scene.Ball->SetPosition(0.01 * i, 0.0, 0.0);
    scene.DrawMoving();
  }
  std::cout << "animation: " << scene.Pass->GetNumberOfCaptures() << " captures\n";
  CHECK_GREATER_EQUAL(scene.Pass->GetNumberOfCaptures(), 3);
  CHECK_LESS_EQUAL(scene.Pass->GetNumberOfCaptures(), 6);
  // The animation has stopped, so captures return after the pause at the latest.
  for (int i = 0; i < 70; ++i)
  {
    scene.DrawMoving();
  }
  const vtkIdType before = scene.Pass->GetNumberOfReliefFrames();
  CHECK_EQUAL(scene.CountCaptures(), 0);
  CHECK_EQUAL(scene.Pass->GetNumberOfReliefFrames(), before + 1);
}

// Views beyond the sides of the capture.
void TestSides(RelevoCheck& check)
{
  RelevoPassScene scene;
  scene.GetCamera()->SetViewAngle(12.0); // only the wall is visible
  CHECK_EQUAL(scene.CountCaptures(), 1);
  scene.GetCamera()->Yaw(0.5);
  CHECK_EQUAL(scene.CountCaptures(), 0); // within the margin
  scene.Pass->SetMaximumHoleShare(1.0);
  scene.GetCamera()->Yaw(5.0);
  const double actual = scene.FindHoles();
  const double predicted = scene.Pass->GetHoleShare();
  std::cout << "sides: holes " << actual << ", predicted " << predicted << "\n";
  CHECK_GREATER(actual, 0.1);
  CHECK_GREATER(predicted, 0.6 * actual);
  CHECK_LESS(predicted, 1.5 * actual);
  scene.Pass->SetMaximumHoleShare(0.005);
  CHECK_EQUAL(scene.CountCaptures(), 1);
}

void TestCloser(RelevoCheck& check)
{
  RelevoPassScene scene;
  scene.Pass->SetMaximumHoleShare(1.0);
  CHECK_EQUAL(scene.CountCaptures(), 1);
  scene.GetCamera()->Zoom(1.8);
  CHECK_EQUAL(scene.CountCaptures(), 0);
  scene.GetCamera()->Zoom(1.3);
  CHECK_EQUAL(scene.CountCaptures(), 1);
  scene.GetCamera()->Zoom(0.5);
  CHECK_EQUAL(scene.CountCaptures(), 0); // uses the first capture
}

void TestChanges(RelevoCheck& check)
{
  RelevoPassScene scene;
  vtkNew<vtkSphereSource> sphere;
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(sphere->GetOutputPort());
  scene.Ball->SetMapper(mapper);
  auto* light = vtkLight::SafeDownCast(scene.Renderer->GetLights()->GetItemAsObject(0));
  scene.DrawMoving();
  const auto step = [&](const std::string& name, const std::function<void()>& change)
  {
    change();
    const vtkIdType first = scene.CountCaptures();
    const vtkIdType second = scene.Pass->GetNumberOfCaptures();
    scene.DrawStill();
    scene.DrawMoving();
    if (first != 1 || scene.Pass->GetNumberOfCaptures() != second)
    {
      check.Fail(__FILE__, __LINE__, name + ": captured " + std::to_string(first) + " times");
    }
  };
  step("colour", [&]() { scene.Ball->GetProperty()->SetColor(1.0, 0.0, 0.0); });
  step("place", [&]() { scene.Ball->SetPosition(0.1, 0.1, 0.0); });
  step("data", [&]() { sphere->SetRadius(0.8); });
  step("hidden", [&]() { scene.Wall->VisibilityOff(); });
  step("shown", [&]() { scene.Wall->VisibilityOn(); });
  step("light", [&]() { light->SetIntensity(0.5); });
  step("removed", [&]() { scene.Renderer->RemoveActor(scene.Wall); });
}
}

int TestReliefPassCaptures(int, char*[])
{
  RelevoCheck check;
  TestAngle(check);
  TestHoleShare(check);
  TestPrediction(check, false);
  TestPrediction(check, true);
  TestTogether(check);
  TestOrbit(check, 5.0, 0.01, 20, 10);
  TestOrbit(check, 1.0, 0.005, 20, 10);
  TestOrbit(check, 5.0, 1e-5, 8, 0);
  TestAnimation(check);
  TestSides(check);
  TestCloser(check);
  TestChanges(check);
  return check.GetResult();
}
