// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Window/ViewerRuler.h"

#include "Scene/ViewerScene.h"
#include "Text/ViewerText.h"
#include "Window/PixelProbe.h"
#include "Window/ViewerFrames.h"

#include "vtkCommand.h"
#include "vtkRenderWindowInteractor.h"

#include <iostream>

//------------------------------------------------------------------------------
ViewerRuler::ViewerRuler(
  vtkRenderWindowInteractor* interactor, ViewerFrames& frames, ViewerScene& scene)
  : Frames(frames)
  , Scene(scene)
{
  interactor->AddObserver(vtkCommand::KeyPressEvent, this, &ViewerRuler::OnKey);
}

//------------------------------------------------------------------------------
void ViewerRuler::OnKey(vtkObject* caller, unsigned long, void*)
{
  auto* interactor = static_cast<vtkRenderWindowInteractor*>(caller);
  if (interactor->GetKeyCode() != 'd')
  {
    return;
  }
  this->Frames.Flush();
  const auto point = FindVisiblePoint(this->Scene, interactor->GetEventPosition());
  if (!point)
  {
    std::cout << "ruler: there is nothing under the mouse" << std::endl;
  }
  else if (!this->First)
  {
    this->First = *point;
    std::cout << "ruler: from " << JoinNumbers({ (*point)[0], (*point)[1], (*point)[2] })
              << "; press d at the other end" << std::endl;
  }
  else
  {
    std::cout << this->Scene.ShowRuler(*this->First, *point) << std::endl;
    this->First.reset();
    interactor->Render();
  }
}
