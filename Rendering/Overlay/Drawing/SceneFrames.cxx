// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing/SceneFrames.h"

#include "Drawing/SceneState.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkRendererCollection.h"

namespace relevo
{
//------------------------------------------------------------------------------
void SceneFrames::Start(vtkRenderWindow* window, vtkRenderer* panels, bool canRepeat)
{
  auto* context = vtkOpenGLRenderWindow::SafeDownCast(window);
  this->CanStore = canRepeat && context && CanRepeatScene(context, panels);
  this->Repeats = this->CanStore && this->HasPanelRequest && !this->HasSceneRequest &&
    this->Background.IsStored() && this->State == FindSceneState(context, panels);
  this->HasPanelRequest = false;
  this->HasSceneRequest = false;
  if (!this->Repeats)
  {
    this->Background.Clear();
    return;
  }
  vtkCollectionSimpleIterator cookie;
  window->GetRenderers()->InitTraversal(cookie);
  while (vtkRenderer* renderer = window->GetRenderers()->GetNextRenderer(cookie))
  {
    if (renderer != panels && renderer->GetDraw())
    {
      renderer->DrawOff();
      this->Skipped.emplace_back(renderer);
    }
  }
}

//------------------------------------------------------------------------------
void SceneFrames::DrawBackground(vtkOpenGLRenderWindow* window, const PixelRectangle& rectangle)
{
  if (this->Repeats)
  {
    this->Background.Restore(window);
  }
  if (this->CanStore)
  {
    this->Background.Store(window, rectangle);
  }
}

//------------------------------------------------------------------------------
void SceneFrames::Finish(vtkRenderWindow* window, vtkRenderer* panels)
{
  for (const auto& renderer : this->Skipped)
  {
    renderer->DrawOn();
  }
  this->Skipped.clear();
  if (this->CanStore && window->GetAbortRender())
  {
    this->Background.Clear();
  }
  if (this->Background.IsStored())
  {
    this->State = FindSceneState(vtkOpenGLRenderWindow::SafeDownCast(window), panels);
  }
}
}
