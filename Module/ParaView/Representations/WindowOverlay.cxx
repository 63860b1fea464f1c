// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "WindowOverlay.h"

#include "Passes/ScreenPass.h"
#include "vtkFXAAOptions.h"
#include "vtkOpenGLFXAAFilter.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLRenderer.h"
#include "vtkOpenGLState.h"

#include <utility>

namespace relevo
{
WindowOverlay::WindowOverlay() = default;
WindowOverlay::~WindowOverlay() = default;

void WindowOverlay::BeginFrame(vtkRenderer* renderer)
{
  this->InFrame = true;
  this->Pictures.clear();
  this->IsSmoothed = renderer->GetUseFXAA();
  renderer->SetUseFXAA(false);
}

void WindowOverlay::SetPictures(
  std::vector<ColorPicture> pictures, const std::array<int, 2>& size, bool areSmoothed)
{
  this->Pictures = std::move(pictures);
  this->Size = size;
  this->AreSmoothed = areSmoothed;
}

void WindowOverlay::EndFrame(vtkRenderer* renderer)
{
  this->InFrame = false;
  renderer->SetUseFXAA(this->IsSmoothed);
  if (this->AreSmoothed)
  {
    this->Blend(renderer);
  }
  if (this->IsSmoothed)
  {
    this->Smooth(renderer);
  }
  if (!this->AreSmoothed)
  {
    this->Blend(renderer);
  }
  this->Pictures.clear();
}

void WindowOverlay::Smooth(vtkRenderer* renderer)
{
  if (auto* opengl = vtkOpenGLRenderer::SafeDownCast(renderer))
  {
    if (renderer->GetFXAAOptions())
    {
      this->Filter->UpdateConfiguration(renderer->GetFXAAOptions());
    }
    this->Filter->Execute(opengl);
  }
}

void WindowOverlay::Blend(vtkRenderer* renderer)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  vtkOpenGLState* state = window->GetState();
  vtkOpenGLState::ScopedglViewport viewport(state);
  vtkOpenGLState::ScopedglScissor scissor(state);
  int size[2];
  int origin[2];
  renderer->GetTiledSizeAndOrigin(&size[0], &size[1], &origin[0], &origin[1]);
  for (ColorPicture& picture : this->Pictures)
  {
    ScreenPass::BlendOver(window,
      [&]
      {
        window->DrawPixels(origin[0], origin[1], origin[0] + size[0] - 1, origin[1] + size[1] - 1,
          0, 0, this->Size[0] - 1, this->Size[1] - 1, this->Size[0], this->Size[1], 4, VTK_FLOAT,
          picture.data());
      });
  }
}

void WindowOverlay::ReleaseGraphicsResources()
{
  this->Filter->ReleaseGraphicsResources();
}
}
