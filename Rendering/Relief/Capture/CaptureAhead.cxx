// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Capture/CaptureAhead.h"

#include "View/WorldView.h"

#include "vtkCamera.h"
#include "vtkNew.h"
#include "vtkTransform.h"

#include <algorithm>

namespace relevo
{
namespace
{
// The number of frames, including its own, that a capture must serve to save time.
constexpr int FewestFrames = 2;
constexpr int MaximumLosses = 3;
constexpr int ShortestPause = 8;
constexpr int LongestPause = 64;
}

void CaptureAhead::MoveTo(vtkCamera* camera)
{
  const dmat4 toView = MakeMatrix(camera->GetViewTransformMatrix());
  const dmat4 fromView = inverse(toView);
  if (this->NumberOfFrames > 0)
  {
    this->Motion = fromView * inverse(this->FromView);
  }
  this->FromView = fromView;
  this->NumberOfFrames = std::min(this->NumberOfFrames + 1, 2);
}

bool CaptureAhead::Advance(vtkCamera* camera) const
{
  double largest = 0.0;
  for (int i = 0; i < 4; ++i)
  {
    const dvec4 change = abs(this->Motion[i] - dmat4(1.0)[i]);
    largest = std::max({ largest, change.x, change.y, change.z });
  }
  if (this->NumberOfFrames < 2 || largest == 0.0)
  {
    return false;
  }
  vtkNew<vtkTransform> motion;
  double rows[16];
  for (int i = 0; i < 16; ++i)
  {
    rows[i] = this->Motion[i % 4][i / 4];
  }
  motion->SetMatrix(rows);
  camera->ApplyTransform(motion);
  return true;
}

bool CaptureAhead::IsWorthwhile()
{
  if (this->FramesLeft > 0)
  {
    --this->FramesLeft;
    return false;
  }
  const bool hasPaid = this->NumberOfShownFrames >= FewestFrames;
  this->NumberOfLosses = hasPaid ? 0 : this->NumberOfLosses + 1;
  this->Pause = hasPaid ? 0 : this->Pause;
  if (this->NumberOfLosses < MaximumLosses)
  {
    return true;
  }
  this->Pause = std::clamp(2 * this->Pause, ShortestPause, LongestPause);
  this->FramesLeft = this->Pause - 1;
  this->NumberOfLosses = MaximumLosses - 2; // allows one capture before the next pause
  this->NumberOfShownFrames = FewestFrames - 1;
  return false;
}
}
