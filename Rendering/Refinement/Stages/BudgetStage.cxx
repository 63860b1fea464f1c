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
// Whether VTK has not drawn the actor yet in this frame.
bool IsFirstPass(vtkActor* actor)
{
  return actor->GetEstimatedRenderTime() == 0.0;
}

// In seconds. An actor within an actor, as vtkLODActor has, is allotted no time of its own.
double GetAllocatedTime(vtkRenderer* renderer, vtkActor* actor)
{
  return std::min(actor->GetAllocatedRenderTime(), renderer->GetAllocatedRenderTime());
}

// Negative to keep the limit that was found last. What has been seen is picked, and later passes
// show what the first has shown. Before a frame, the actor has not been allotted its time yet.
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
