// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Window/ViewerFrames.h"

#include "Scene/PassiveObserver.h"

#include "vtkCommand.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"

#include <utility>

namespace
{
const unsigned long FrameDelay = 1; // milliseconds
// A continuous stream of events must not postpone a frame forever.
const int MaximumDelays = 10;
}

//------------------------------------------------------------------------------
ViewerFrames::ViewerFrames(vtkRenderWindowInteractor* interactor, std::function<void()> beforeFrame)
  : Interactor(interactor)
  , BeforeFrame(std::move(beforeFrame))
{
  interactor->EnableRenderOff();
  AddPassiveObserver(interactor, vtkCommand::RenderEvent, [this](void*) { this->OnRender(); });
  AddPassiveObserver(interactor, vtkCommand::TimerEvent,
    [this](void* data) { this->OnTimer(*static_cast<int*>(data)); });
}

//------------------------------------------------------------------------------
void ViewerFrames::Flush()
{
  if (this->Timer > 0)
  {
    this->Interactor->DestroyTimer(this->Timer);
    this->Draw();
  }
}

//------------------------------------------------------------------------------
void ViewerFrames::Draw()
{
  this->Timer = 0;
  this->Requests = 0;
  this->Delays = 0;
  this->BeforeFrame();
  this->Interactor->GetRenderWindow()->Render();
}

//------------------------------------------------------------------------------
void ViewerFrames::OnRender()
{
  ++this->Requests;
  if (this->Timer == 0)
  {
    this->StartTimer();
  }
}

//------------------------------------------------------------------------------
void ViewerFrames::OnTimer(int timer)
{
  if (timer != this->Timer)
  {
    return;
  }
  // VTK 9.1 handles timers after every event, even if more events wait.
  if (this->Requests > this->Handled && this->Delays < MaximumDelays)
  {
    ++this->Delays;
    this->StartTimer();
    return;
  }
  // VTK destroys the timer.
  this->Draw();
}

//------------------------------------------------------------------------------
void ViewerFrames::StartTimer()
{
  this->Handled = this->Requests;
  this->Timer = this->Interactor->CreateOneShotTimer(FrameDelay);
}
