// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Window/ViewerLoading.h"

#include "Scene/PassiveObserver.h"
#include "Scene/ViewerScene.h"

#include "vtkCommand.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"

#include <optional>

//------------------------------------------------------------------------------
ViewerLoading::ViewerLoading(vtkRenderWindowInteractor* interactor, ViewerScene& scene)
  : Interactor(interactor)
  , Scene(scene)
{
  AddPassiveObserver(scene.GetRenderer(), vtkCommand::EndEvent, [this](void*) { this->OnFrame(); });
  AddPassiveObserver(interactor, vtkCommand::TimerEvent,
    [this](void* data) { this->OnTimer(*static_cast<int*>(data)); });
}

//------------------------------------------------------------------------------
void ViewerLoading::OnFrame()
{
  const std::optional<int> delay = this->Scene.GetFrameDelay();
  if (delay && this->Timer == 0)
  {
    this->Timer = this->Interactor->CreateOneShotTimer(*delay);
  }
}

//------------------------------------------------------------------------------
void ViewerLoading::OnTimer(int timer)
{
  if (timer == this->Timer)
  {
    this->Timer = 0;
    this->Interactor->Render();
  }
}
