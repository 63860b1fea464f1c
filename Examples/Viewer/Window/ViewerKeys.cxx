// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Window/ViewerKeys.h"

#include "Scene/ViewerScene.h"

#include "vtkCommand.h"
#include "vtkRenderWindowInteractor.h"

#include <iostream>

//------------------------------------------------------------------------------
ViewerKeys::ViewerKeys(vtkRenderWindowInteractor* interactor, ViewerScene& scene)
  : Scene(scene)
{
  interactor->AddObserver(vtkCommand::KeyPressEvent, this, &ViewerKeys::OnKey);
}

//------------------------------------------------------------------------------
void ViewerKeys::OnKey(vtkObject* caller, unsigned long, void*)
{
  auto* interactor = static_cast<vtkRenderWindowInteractor*>(caller);
  std::string text = this->Scene.ChangeByKey(interactor->GetKeyCode());
  if (text.empty() && !this->Scene.IsTerrain())
  {
    text = this->Scene.ShowPlanView(interactor->GetKeyCode());
  }
  if (!text.empty())
  {
    std::cout << text << std::endl;
    interactor->Render();
  }
}
