// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/RenderClock.h"

#include "vtkTimerLog.h"

namespace relevo
{
void RenderClock::Start()
{
  this->StartTime = vtkTimerLog::GetUniversalTime();
  this->Timer.ReusableStart();
}

double RenderClock::Stop()
{
  this->Timer.ReusableStop();
  return vtkTimerLog::GetUniversalTime() - this->StartTime +
    static_cast<double>(this->Timer.GetReusableElapsedSeconds());
}

void RenderClock::ReleaseGraphicsResources()
{
  this->Timer.ReleaseGraphicsResources();
}
}
