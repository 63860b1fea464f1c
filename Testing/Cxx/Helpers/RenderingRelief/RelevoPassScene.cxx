// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RelevoPassScene.h"

#include "vtkPlaneSource.h"
#include "vtkProperty.h"
#include "vtkSphereSource.h"

#include <cmath>

RelevoPassScene::RelevoPassScene()
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-4.0, -4.0, -1.0);
  plane->SetPoint1(4.0, -4.0, -1.0);
  plane->SetPoint2(-4.0, 4.0, -1.0);
  plane->Update();
  this->Wall = this->Add(plane->GetOutput());
  for (int i = 0; i < 5; ++i)
  {
    vtkNew<vtkSphereSource> sphere;
    sphere->SetRadius(0.2 + 0.1 * i);
    sphere->SetThetaResolution(40);
    sphere->SetPhiResolution(40);
    sphere->SetCenter(-2.0 + i, std::sin(2.0 * i), 0.5 - 0.2 * i);
    sphere->Update();
    this->Ball = this->Add(sphere->GetOutput());
    this->Ball->GetProperty()->SetColor(0.2 * i, 0.8, 1.0 - 0.2 * i);
  }
  vtkCamera* camera = this->GetCamera();
  camera->SetPosition(0.5, 1.0, 14.0);
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  this->Renderer->ResetCameraClippingRange();
  this->Renderer->SetPass(this->Pass);
}

RelevoPicture RelevoPassScene::DrawMoving()
{
  this->Renderer->ResetCameraClippingRange();
  this->Window->SetDesiredUpdateRate(15.0);
  this->Window->Render();
  this->Window->SetDesiredUpdateRate(0.001);
  return RelevoPicture(this->Window);
}

RelevoPicture RelevoPassScene::DrawStill()
{
  this->Renderer->ResetCameraClippingRange();
  this->Window->SetDesiredUpdateRate(0.001);
  this->Window->Render();
  return RelevoPicture(this->Window);
}

double RelevoPassScene::GetDistance(float z)
{
  double range[2];
  this->GetCamera()->GetClippingRange(range);
  return range[0] * range[1] / (range[1] - z * (range[1] - range[0]));
}

double RelevoPassScene::FindHoles()
{
  const RelevoPicture moving = this->DrawMoving();
  const RelevoPicture still = this->DrawStill();
  size_t shown = 0;
  size_t open = 0;
  for (size_t i = 0; i < still.GetNumberOfPixels(); ++i)
  {
    if (still.Depths[i] < 1.0f)
    {
      ++shown;
      open += this->GetDistance(moving.Depths[i]) > this->GetDistance(still.Depths[i]) + 0.1;
    }
  }
  return static_cast<double>(open) / shown;
}

vtkIdType RelevoPassScene::CountCaptures()
{
  const vtkIdType before = this->Pass->GetNumberOfCaptures();
  this->DrawMoving();
  return this->Pass->GetNumberOfCaptures() - before;
}
