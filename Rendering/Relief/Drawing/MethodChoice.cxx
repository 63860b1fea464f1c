// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing/MethodChoice.h"

#include "OpenGL/RelevoOpenGL.h"

#include "vtkTimerLog.h"

#include <algorithm>
#include <limits>

namespace relevo
{
MethodChoice::MethodChoice(const std::vector<int>& candidates)
  : Candidates(candidates)
{
}

int MethodChoice::Begin(const Dependencies& source, double pixels)
{
  const bool isOther = this->Source.Update(source);
  if (isOther || pixels > 2.0 * this->Pixels || 2.0 * pixels < this->Pixels)
  {
    this->Pixels = pixels;
    this->Frame = 0;
    this->Seconds.assign(this->Candidates.size(), std::numeric_limits<double>::infinity());
  }
  const size_t candidate = this->Frame / Rounds;
  if (candidate >= this->Candidates.size())
  {
    return this->Get();
  }
  glFinish();
  this->StartTime = vtkTimerLog::GetUniversalTime();
  return this->Candidates[candidate];
}

void MethodChoice::End()
{
  const size_t candidate = this->Frame / Rounds;
  if (candidate >= this->Candidates.size())
  {
    return;
  }
  glFinish();
  const double seconds = vtkTimerLog::GetUniversalTime() - this->StartTime;
  if (this->Frame % Rounds > 0)
  {
    this->Seconds[candidate] = std::min(this->Seconds[candidate], seconds);
  }
  ++this->Frame;
  this->Fastest = static_cast<int>(
    std::min_element(this->Seconds.begin(), this->Seconds.end()) - this->Seconds.begin());
}
}
