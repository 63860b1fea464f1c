// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Window/FrameRequests.h"

#include "vtkCommand.h"
#include "vtkRenderWindowInteractor.h"

namespace relevo
{
//------------------------------------------------------------------------------
FrameRequests::FrameRequests(vtkRenderWindowInteractor* interactor)
  : Interactor(interactor)
  , WasEnabled(interactor->GetEnableRender())
  , Observer(interactor->AddObserver(vtkCommand::RenderEvent, this, &FrameRequests::OnRender))
{
  interactor->EnableRenderOff();
}

//------------------------------------------------------------------------------
FrameRequests::~FrameRequests()
{
  this->Interactor->RemoveObserver(this->Observer);
  this->Interactor->SetEnableRender(this->WasEnabled);
}
}
