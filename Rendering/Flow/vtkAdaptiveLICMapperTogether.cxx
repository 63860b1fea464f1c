// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// The streaks of a picture that several processes draw together. All of them come to each exchange,
// whatever they have to show and whatever fails.
#include "vtkAdaptiveLICMapperInternals.h"

#include "vtkActor.h"
#include "vtkMultiProcessController.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLRenderer.h"
#include "vtkOpenGLState.h"

#include <algorithm>

void vtkAdaptiveLICMapper::SetController(vtkMultiProcessController* controller)
{
  this->LIC->Controller = controller;
}

vtkMultiProcessController* vtkAdaptiveLICMapper::GetController()
{
  return this->LIC->Controller;
}

bool vtkAdaptiveLICMapper::vtkInternals::IsTogether() const
{
  return this->Controller && this->Controller->GetNumberOfProcesses() > 1;
}

void vtkAdaptiveLICMapper::PrepareParallelFrame(vtkRenderer* ren, vtkActor* act)
{
  vtkInternals& lic = *this->LIC;
  if (!lic.IsTogether())
  {
    return;
  }
  // As when the picture is drawn, which has not begun.
  vtkOpenGLRenderWindow* window = vtkOpenGLRenderWindow::SafeDownCast(ren->GetRenderWindow());
  int viewport[4];
  ren->GetTiledSizeAndOrigin(viewport + 2, viewport + 3, viewport, viewport + 1);
  window->GetState()->vtkglViewport(viewport[0], viewport[1], viewport[2], viewport[3]);
  ren->UpdateLightsGeometryToFollowCamera();
  vtkOpenGLRenderer::SafeDownCast(ren)->UpdateLights();

  lic.LocalContribution.reset(new vtkInternals::Part);
  act->Render(ren, this);
  const auto key = std::make_pair(ren, act);
  const bool tookPart = lic.PreviousContributors.count(key) > 0;
  if (lic.LocalContribution->Screen)
  {
    lic.PreviousContributors.insert(key);
  }
  else
  {
    lic.PreviousContributors.erase(key);
  }
  bool changed = false;
  if (lic.Agree(tookPart, changed))
  {
    lic.DrawTogether(ren, act, changed);
  }
  lic.SetProblem(lic.LocalContribution->Problem);
  lic.LocalContribution.reset();
}

void vtkAdaptiveLICMapper::vtkInternals::TakePart(vtkRenderer* ren, vtkActor* act)
{
  Part& part = *this->LocalContribution;
  if (part.DrawsVectors && part.Screen)
  {
    part.Problem = this->DrawVectors(ren, act, *part.Screen, &part.Vectors);
    return;
  }
  if (part.DrawsVectors || !this->CanShow(ren, act))
  {
    return;
  }
  this->CheckVectors();
  part.Problem = this->OwnVectors.Problem;
  if (part.Problem.empty())
  {
    part.Problem = this->FindSettingsProblem();
  }
  relevo::LICScreen& screen = this->GetScreen(ren, act);
  if (part.Problem.empty())
  {
    part.Problem = this->AllocateScreen(ren, screen);
  }
  part.Actor = act;
  part.Screen = &screen;
  part.IsChanged = screen.Sources != this->GetScreenDependencies(ren, act, screen);
}

bool vtkAdaptiveLICMapper::vtkInternals::Agree(bool tookPart, bool& changed)
{
  enum
  {
    SHOWS,
    CHANGED,
    PROBLEM,
    FACES,
    ARRAY,
    LONGEST,
    SAME // from here on, in pairs: values, and the values negative
  };
  Part& part = *this->LocalContribution;
  std::vector<double> values(SAME + 6, -VTK_DOUBLE_MAX);
  values[CHANGED] = part.IsChanged || tookPart != (part.Screen != nullptr);
  if (part.Screen)
  {
    values[SHOWS] = 1.0;
    values[PROBLEM] = !part.Problem.empty();
    values[FACES] = this->OwnVectors.HasFaces;
    values[ARRAY] = this->OwnVectors.HasArray;
    values[LONGEST] = this->OwnVectors.Longest;
    const int same[3] = { part.Screen->Viewport[2], part.Screen->Viewport[3],
      this->CountRanges(true) };
    for (int i = 0; i < 3; ++i)
    {
      values[SAME + 2 * i] = same[i];
      values[SAME + 2 * i + 1] = -same[i];
    }
  }
  relevo::LICProcesses(this->Controller).Maximize(values);
  changed = values[CHANGED] > 0.0;
  this->AllVectors = { values[FACES] > 0.0, values[ARRAY] > 0.0, values[LONGEST], "", "" };
  std::string problem = this->FindVectorProblem();
  for (int i = SAME; i < SAME + 6; i += 2)
  {
    if (values[SHOWS] > 0.0 && values[i] != -values[i + 1])
    {
      problem = "The processes have different sizes of the viewport, or settings.";
    }
  }
  // One tells for all.
  if (values[PROBLEM] <= 0.0 && this->Controller->GetLocalProcessId() == 0)
  {
    part.Problem = problem;
  }
  const bool agreed = values[SHOWS] > 0.0 && values[PROBLEM] <= 0.0 && problem.empty();
  if (!agreed && part.Screen)
  {
    part.Screen->Sources.Clear();
  }
  return agreed;
}

void vtkAdaptiveLICMapper::vtkInternals::DrawTogether(vtkRenderer* ren, vtkActor* act, bool changed)
{
  if (!changed && !this->StretchesColors())
  {
    return;
  }
  Part& part = *this->LocalContribution;
  relevo::LICScreen*& screen = part.Screen;
  const relevo::LICProcesses processes(this->Controller);
  if (screen)
  {
    part.DrawsVectors = true;
    act->Render(ren, this->Root);
  }
  if (changed)
  {
    int rectangle[4] = { 0, 0, 0, 0 };
    if (screen && !part.Vectors.empty())
    {
      std::copy(screen->Rectangle, screen->Rectangle + 4, rectangle);
    }
    processes.Composite(rectangle, part.Vectors);
    if (screen)
    {
      screen->WriteVectors(rectangle, part.Vectors);
      screen->GrowConvolved(relevo::LICImage::FindReach(this->GetPassSettings()));
    }
  }
  int ranges = this->CountRanges(changed);
  const auto merge = [&](float range[2])
  {
    processes.MergeRange(range);
    --ranges;
  };
  if (screen && part.Problem.empty())
  {
    part.Problem = this->DrawImage(ren, *screen, changed, merge);
  }
  while (ranges > 0)
  {
    float nothing[2] = { VTK_FLOAT_MAX, -VTK_FLOAT_MAX };
    merge(nothing);
  }
  if (screen)
  {
    screen->Sources = part.Problem.empty() ? this->GetScreenDependencies(ren, part.Actor, *screen)
                                           : relevo::Dependencies();
  }
}

int vtkAdaptiveLICMapper::vtkInternals::CountRanges(bool convolve) const
{
  return (convolve ? relevo::LICImage::CountRanges(this->GetPassSettings()) : 0) +
    (this->StretchesColors() ? 1 : 0);
}
