// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "View/EventPace.h"

#include "vtkCommand.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkTimerLog.h"

#include <algorithm>

namespace relevo
{
namespace
{
// An event that comes later has not waited for the previous frame.
constexpr double LongestWait = 0.002;
constexpr double LeastFactor = 1.0 / 64.0;
constexpr double SlowerFactor = 1.2;

bool IsMoving(vtkRenderWindow* window)
{
  return window->GetInteractor() && window->GetDesiredUpdateRate() >= 1.0;
}
}

void EventPace::SetWindow(vtkRenderWindow* window)
{
  if (this->Window == window)
  {
    return;
  }
  if (this->Window)
  {
    this->Window->RemoveObserver(this->Tags[0]);
    this->Window->RemoveObserver(this->Tags[1]);
  }
  this->Window = window;
  this->Factor = 1.0;
  this->EndTime = 0.0;
  if (window)
  {
    this->Tags[0] = window->AddObserver(vtkCommand::StartEvent, this, &EventPace::OnStart);
    this->Tags[1] = window->AddObserver(vtkCommand::EndEvent, this, &EventPace::OnEnd);
  }
}

void EventPace::OnStart()
{
  this->Begin(IsMoving(this->Window), vtkTimerLog::GetUniversalTime());
}

void EventPace::OnEnd()
{
  this->End(IsMoving(this->Window), vtkTimerLog::GetUniversalTime());
}

void EventPace::Begin(bool isMoving, double time)
{
  if (!isMoving)
  {
    this->Factor = 1.0;
  }
  else if (this->EndTime > 0.0)
  {
    const bool hasWaited = time - this->EndTime < LongestWait;
    this->Factor = std::clamp(this->Factor * (hasWaited ? 0.5 : SlowerFactor), LeastFactor, 1.0);
  }
}

void EventPace::End(bool isMoving, double time)
{
  this->EndTime = isMoving ? time : 0.0;
}
}
