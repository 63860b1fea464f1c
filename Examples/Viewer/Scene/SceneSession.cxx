// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/SceneSession.h"

#include "Options/ViewerOptions.h"
#include "Scene/ViewerScene.h"

#include "vtkCamera.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <algorithm>

//------------------------------------------------------------------------------
void SetCamera(vtkRenderer* renderer, const SessionCamera& camera)
{
  vtkCamera* view = renderer->GetActiveCamera();
  view->SetPosition(camera.Position.data());
  view->SetFocalPoint(camera.FocalPoint.data());
  view->SetViewUp(camera.ViewUp.data());
  view->SetViewAngle(camera.ViewAngle);
  view->SetParallelScale(camera.ParallelScale);
  view->SetParallelProjection(camera.IsParallel);
  renderer->ResetCameraClippingRange();
}

//------------------------------------------------------------------------------
SessionCamera GetCamera(vtkRenderer* renderer)
{
  vtkCamera* view = renderer->GetActiveCamera();
  SessionCamera camera;
  std::copy_n(view->GetPosition(), 3, camera.Position.begin());
  std::copy_n(view->GetFocalPoint(), 3, camera.FocalPoint.begin());
  std::copy_n(view->GetViewUp(), 3, camera.ViewUp.begin());
  camera.ViewAngle = view->GetViewAngle();
  camera.ParallelScale = view->GetParallelScale();
  camera.IsParallel = view->GetParallelProjection() != 0;
  return camera;
}

//------------------------------------------------------------------------------
void SaveSceneSession(ViewerScene& scene, const ViewerOptions& options)
{
  ViewerSession session;
  session.Input = options.Input;
  session.Options = options.Given;
  if (vtkRenderWindow* window = scene.GetRenderer()->GetRenderWindow())
  {
    const int* size = window->GetSize();
    session.Options["--size"] = std::to_string(size[0]) + "x" + std::to_string(size[1]);
  }
  session.Camera = GetCamera(scene.GetRenderer());
  WriteSession(options.SaveSession, session);
}

//------------------------------------------------------------------------------
void SaveSession(ViewerScene& scene, const ViewerOptions& options)
{
  ViewerOptions changed = options;
  for (const auto& change : scene.GetChanges())
  {
    changed.Given[change.first] = change.second;
  }
  SaveSceneSession(scene, changed);
}
