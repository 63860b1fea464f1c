// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Window/EventInteractor.h"

#include "vtkCommand.h"
#include "vtkInteractorStyleTrackballCamera.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <vector>

namespace relevo
{
vtkStandardNewMacro(EventInteractor);

//------------------------------------------------------------------------------
EventInteractor::EventInteractor()
{
  vtkNew<vtkInteractorStyleTrackballCamera> style;
  this->SetInteractorStyle(style);
}

//------------------------------------------------------------------------------
EventInteractor::~EventInteractor() = default;

//------------------------------------------------------------------------------
void EventInteractor::Initialize()
{
  this->Initialized = 1;
  this->Enable();
}

//------------------------------------------------------------------------------
void EventInteractor::Start()
{
  this->Initialize();
}

//------------------------------------------------------------------------------
void EventInteractor::ProcessEvents()
{
}

//------------------------------------------------------------------------------
void EventInteractor::TerminateApp()
{
}

//------------------------------------------------------------------------------
void EventInteractor::FireTimers(const Time& now)
{
  std::vector<int> due;
  for (const auto& timer : this->Timers)
  {
    if (timer.second.End <= now)
    {
      due.push_back(timer.first);
    }
  }
  for (const int number : due)
  {
    const auto found = this->Timers.find(number); // observers can destroy timers
    if (found == this->Timers.end())
    {
      continue;
    }
    int id = found->second.Id;
    const bool isRepeating = found->second.Period.count() > 0;
    if (isRepeating)
    {
      found->second.End = now + found->second.Period;
    }
    this->InvokeEvent(vtkCommand::TimerEvent, &id);
    if (!isRepeating)
    {
      this->DestroyTimer(id);
    }
  }
}

//------------------------------------------------------------------------------
std::optional<EventInteractor::Time> EventInteractor::GetNextTimer() const
{
  std::optional<Time> next;
  for (const auto& timer : this->Timers)
  {
    next = next ? std::min(*next, timer.second.End) : timer.second.End;
  }
  return next;
}

//------------------------------------------------------------------------------
int EventInteractor::InternalCreateTimer(int id, int type, unsigned long duration)
{
  const std::chrono::milliseconds wait(std::max(duration, 1ul));
  const bool isRepeating = type == vtkRenderWindowInteractor::RepeatingTimer;
  this->Timers[++this->LastTimer] = { id, std::chrono::steady_clock::now() + wait,
    isRepeating ? wait : std::chrono::milliseconds(0) };
  return this->LastTimer;
}

//------------------------------------------------------------------------------
int EventInteractor::InternalDestroyTimer(int platformId)
{
  return this->Timers.erase(platformId) > 0 ? 1 : 0;
}
}
