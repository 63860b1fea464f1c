// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Stages/BudgetStage.h"

#include "Parallel/PieceReduction.h"
#include "vtkActor.h"
#include "vtkRenderer.h"

#include <algorithm>

namespace relevo
{
namespace
{
// Return whether VTK has not yet drawn the actor in this frame.
bool IsFirstPass(vtkActor* actor)
{
  return actor->GetEstimatedRenderTime() == 0.0;
}

// Return the time in seconds. An actor inside another, as in vtkLODActor, has no allotted time.
double GetAllocatedTime(vtkRenderer* renderer, vtkActor* actor)
{
  return std::min(actor->GetAllocatedRenderTime(), renderer->GetAllocatedRenderTime());
}

// Return a negative time to keep the last limit. Picking uses what has been drawn, and later passes
// draw the same as the first. Before a frame, the actor has no allotted time yet.
double GetTime(const BudgetStage::Input& input)
{
  return !input.UsesAllocatedTime              ? 0.0
    : input.Renderer->GetSelector() != nullptr ? -1.0
    : input.Pieces                             ? input.Renderer->GetAllocatedRenderTime()
    : IsFirstPass(input.Actor)                 ? GetAllocatedTime(input.Renderer, input.Actor)
                                               : -1.0;
}
}

bool BudgetStage::Begin(const Input& input)
{
  const bool isBudgeted = this->Budget.SetView(input.Renderer->GetActiveCamera(), GetTime(input));
  std::vector<double> budgets(1, isBudgeted ? 1.0 : 0.0);
  if (input.Pieces)
  {
    input.Pieces->TakeLargest(budgets);
  }
  return budgets[0] > 0.0;
}

double BudgetStage::FindOffset(const std::vector<LevelBudget::Part>& parts,
  vtkAdaptiveRefinement* recipe, const PieceReduction* pieces)
{
  const PieceReduction alone;
  return this->Budget.FindOffset(parts, recipe, pieces ? *pieces : alone);
}

void BudgetStage::Measure(vtkRenderer* renderer, vtkActor* actor, const std::function<void()>& draw,
  const std::function<vtkIdType(bool)>& countTriangles)
{
  this->Clock.Start();
  draw();
  const double seconds = this->Clock.Stop();
  const vtkIdType triangles = countTriangles(seconds > GetAllocatedTime(renderer, actor));
  this->Budget.AddPass(IsFirstPass(actor), triangles, seconds);
}
}
