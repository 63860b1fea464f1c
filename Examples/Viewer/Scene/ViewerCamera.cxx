// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/ViewerCamera.h"

#include "vtkCamera.h"
#include "vtkCommand.h"
#include "vtkMath.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>

//------------------------------------------------------------------------------
ViewerCamera::ViewerCamera(vtkRenderer* renderer)
  : Renderer(renderer)
{
  this->Tags[0] = renderer->AddObserver(vtkCommand::StartEvent, this, &ViewerCamera::OnStart);
  this->Tags[1] = renderer->AddObserver(
    vtkCommand::ResetCameraClippingRangeEvent, this, &ViewerCamera::OnClippingRange);
}

//------------------------------------------------------------------------------
ViewerCamera::~ViewerCamera()
{
  this->Renderer->RemoveObserver(this->Tags[0]);
  this->Renderer->RemoveObserver(this->Tags[1]);
}

//------------------------------------------------------------------------------
void ViewerCamera::Update()
{
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  if (camera->GetMTime() != this->CameraTime)
  {
    this->MoveOut(camera);
    this->Renderer->ResetCameraClippingRange();
    this->CameraTime = camera->GetMTime();
  }
}

//------------------------------------------------------------------------------
double ViewerCamera::GetMinimumDistance(vtkCamera* camera)
{
  return 0.2 * camera->GetDistance();
}

//------------------------------------------------------------------------------
void ViewerCamera::OnStart(vtkObject*, unsigned long, void*)
{
  this->Update();
}

//------------------------------------------------------------------------------
void ViewerCamera::OnClippingRange(vtkObject*, unsigned long, void*)
{
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  if (camera->GetParallelProjection())
  {
    return;
  }
  // In a corner of the picture, a point's depth is smaller than its distance.
  const double tangent = std::tan(0.5 * vtkMath::RadiansFromDegrees(camera->GetViewAngle()));
  const double depth = this->GetMinimumDistance(camera) /
    std::hypot(1.0, std::hypot(tangent, tangent * this->Renderer->GetTiledAspectRatio()));
  double range[2];
  camera->GetClippingRange(range);
  // Relative to the far plane's distance, because depth buffers have 24 bits.
  const double minimumShare = 1e-7;
  const double nearest = std::max(depth, minimumShare * range[1]);
  if (nearest < range[0])
  {
    camera->SetClippingRange(nearest, range[1]);
  }
}
