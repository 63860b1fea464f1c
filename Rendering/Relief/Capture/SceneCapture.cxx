// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Capture/SceneCapture.h"

#include "Capture/CaptureRanks.h"
#include "Capture/CapturedImage.h"

#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkMultiProcessController.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"

namespace relevo
{
std::string SceneCapture::Begin(vtkRenderer* renderer, SceneParts parts, int width, int height)
{
  std::string error = this->Prepare(renderer, parts, width, height);
  if (this->Ranks)
  {
    this->Props.Corners = this->Ranks->Collect(this->Props.Corners);
  }
  if (error.empty() && this->Props.Corners.empty())
  {
    error = "The renderer has no visible props with opaque geometry, so there is nothing to "
            "capture.";
  }
  return error;
}

std::string SceneCapture::Prepare(vtkRenderer* renderer, SceneParts parts, int width, int height)
{
  if (!renderer)
  {
    return "There is no renderer to capture: call SetRenderer().";
  }
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  if (!window)
  {
    return "The renderer is not in a window that draws with OpenGL.";
  }
  window->Initialize();
  window->MakeCurrent();
  if (!window->IsCurrent())
  {
    return "The window of the renderer has no OpenGL context.";
  }
  this->Props = FindSceneProps(renderer, parts);
  this->Target.reset(new CaptureTarget);
  const std::string error = this->Target->Allocate(window, width, height);
  this->Renderer = vtkSmartPointer<CaptureRenderer>::New();
  this->Renderer->Follow(renderer);
  this->Renderer->SetCaptureSize(width, height);
  this->Size[0] = width;
  this->Size[1] = height;
  this->NearClippingPlaneTolerance = renderer->GetNearClippingPlaneTolerance();
  return error;
}

void SceneCapture::End()
{
  if (this->Renderer)
  {
    auto* window = vtkOpenGLRenderWindow::SafeDownCast(this->Renderer->GetRenderWindow());
    window->GetShaderCache()->ReleaseCurrentShader();
  }
  this->Target = nullptr;
  this->Renderer = nullptr;
  this->Props = SceneProps();
}

vtkSmartPointer<vtkImageData> SceneCapture::CaptureFrom(
  vtkCamera* camera, bool withNormals, bool cropped)
{
  const FittedCamera fitted = FitCamera(
    camera, this->Size[0], this->Size[1], this->Props.Corners, this->NearClippingPlaneTolerance);
  this->IsSingular = fitted.IsSingular;
  if (!fitted.Camera)
  {
    return nullptr;
  }
  this->Renderer->SetActiveCamera(fitted.Camera);
  this->Renderer->PlaceLights();
  this->Pass->Draw(this->Renderer, this->Props.Opaque, *this->Target);
  CapturedPixels pixels;
  this->Target->Read(pixels);
  if (this->Ranks)
  {
    this->Ranks->Composite(pixels);
    if (this->Ranks->GetController() && this->Ranks->GetController()->GetLocalProcessId() > 0)
    {
      return nullptr;
    }
  }
  return MakeCapturedImage(pixels, fitted, withNormals, cropped);
}
}
