// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Stages/LICParallelFrame.h"

#include "Passes/LICProcesses.h"
#include "Passes/LICScreen.h"
#include "vtkMultiProcessController.h"

#include <algorithm>

namespace relevo
{
LICParallelFrame::LICParallelFrame() = default;
LICParallelFrame::~LICParallelFrame() = default;

void LICParallelFrame::SetController(vtkMultiProcessController* controller)
{
  this->Controller = controller;
}

vtkMultiProcessController* LICParallelFrame::GetController() const
{
  return this->Controller;
}

bool LICParallelFrame::IsUsed() const
{
  return this->Controller && this->Controller->GetNumberOfProcesses() > 1;
}

void LICParallelFrame::ForgetScreen()
{
  if (this->Local)
  {
    this->Local->Screen = nullptr;
  }
}

std::string LICParallelFrame::Run(
  vtkRenderer* ren, vtkActor* act, LICVectorField& field, const Steps& steps)
{
  this->Local.reset(new Contribution);
  steps.Prepare(*this->Local);
  const auto key = std::make_pair(ren, act);
  const bool didContribute = this->PreviousContributors.count(key) > 0;
  if (this->Local->Screen)
  {
    this->PreviousContributors.insert(key);
  }
  else
  {
    this->PreviousContributors.erase(key);
  }
  bool changed = false;
  if (this->Agree(field, steps, didContribute, changed) && (changed || steps.StretchesColors))
  {
    this->Draw(steps, changed);
  }
  const std::string error = this->Local->Error;
  this->Local.reset();
  return error;
}

bool LICParallelFrame::Agree(
  LICVectorField& field, const Steps& steps, bool didContribute, bool& changed)
{
  enum
  {
    SHOWS,
    CHANGED,
    PROBLEM,
    FACES,
    ARRAY,
    LONGEST,
    SAME // first of the values that must agree, in pairs: the value and its negative
  };
  Contribution& local = *this->Local;
  std::vector<double> values(SAME + 6, -VTK_DOUBLE_MAX);
  values[CHANGED] = local.IsChanged || didContribute != (local.Screen != nullptr);
  if (local.Screen)
  {
    values[SHOWS] = 1.0;
    values[PROBLEM] = !local.Error.empty();
    values[FACES] = field.GetOwn().HasFaces;
    values[ARRAY] = field.GetOwn().HasArray;
    values[LONGEST] = field.GetOwn().Longest;
    const int same[3] = { local.Screen->Viewport[2], local.Screen->Viewport[3],
      steps.CountRanges(true) };
    for (int i = 0; i < 3; ++i)
    {
      values[SAME + 2 * i] = same[i];
      values[SAME + 2 * i + 1] = -same[i];
    }
  }
  LICProcesses(this->Controller).Maximize(values);
  changed = values[CHANGED] > 0.0;
  field.SetAll({ values[FACES] > 0.0, values[ARRAY] > 0.0, values[LONGEST], "" });
  std::string error = field.FindError();
  for (int i = SAME; i < SAME + 6; i += 2)
  {
    if (values[SHOWS] > 0.0 && values[i] != -values[i + 1])
    {
      error = "The ranks have different viewport sizes or settings.";
    }
  }
  // One process reports for all.
  if (values[PROBLEM] <= 0.0 && this->Controller->GetLocalProcessId() == 0)
  {
    local.Error = error;
  }
  const bool agreed = values[SHOWS] > 0.0 && values[PROBLEM] <= 0.0 && error.empty();
  if (!agreed && local.Screen)
  {
    local.Screen->Sources.Clear();
  }
  return agreed;
}

void LICParallelFrame::Draw(const Steps& steps, bool changed)
{
  Contribution& local = *this->Local;
  LICScreen*& screen = local.Screen; // forgotten if its resources are released meanwhile
  const LICProcesses processes(this->Controller);
  if (screen)
  {
    steps.DrawVectors(local);
  }
  if (changed)
  {
    int rectangle[4] = { 0, 0, 0, 0 };
    if (screen && !local.Vectors.empty())
    {
      std::copy(screen->Rectangle, screen->Rectangle + 4, rectangle);
    }
    processes.Composite(rectangle, local.Vectors);
    if (screen)
    {
      screen->WriteVectors(rectangle, local.Vectors);
      screen->GrowConvolved(steps.FindReach());
    }
  }
  int ranges = steps.CountRanges(changed);
  const auto merge = [&](float range[2])
  {
    processes.MergeRange(range);
    --ranges;
  };
  if (screen && local.Error.empty())
  {
    local.Error = steps.DrawImage(*screen, changed, merge);
  }
  while (ranges > 0)
  {
    float nothing[2] = { VTK_FLOAT_MAX, -VTK_FLOAT_MAX };
    merge(nothing);
  }
  if (screen)
  {
    screen->Sources.Clear();
    if (local.Error.empty())
    {
      steps.Finish(*screen);
    }
  }
}
}
