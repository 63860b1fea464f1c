// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "State/LevelBudget.h"

#include "Parallel/PieceReduction.h"
#include "Patterns/PatternFamily.h"
#include "State/RefinementState.h"
#include "vtkAdaptiveRefinement.h"

#include <algorithm>

namespace relevo
{
void LevelBudget::AddPass(bool first, vtkIdType triangles, double seconds)
{
  if (first)
  {
    this->Times.AddFrame(this->FrameTriangles, this->FrameSeconds);
    this->FrameSeconds = 0.0;
  }
  this->FrameTriangles = triangles;
  this->FrameSeconds += seconds;
}

bool LevelBudget::SetView(const vtkCamera* camera, double seconds)
{
  auto view = std::find_if(this->Views.begin(), this->Views.end(),
    [camera](const View& other) { return other.Camera == camera; });
  if (view == this->Views.end())
  {
    if (this->Views.size() == RefinementState::MaximumViews)
    {
      this->Views.erase(this->Views.begin());
    }
    this->Views.emplace_back();
    this->Views.back().Camera = camera;
  }
  else
  {
    std::rotate(view, view + 1, this->Views.end());
  }
  vtkIdType& limit = this->Views.back().Limit;
  if (seconds >= 0.0)
  {
    limit = seconds > 0.0 ? this->Times.FindLimit(seconds, limit) : 0;
  }
  return this->Target > 0 || limit > 0;
}

double LevelBudget::FindOffset(
  const std::vector<Part>& parts, vtkAdaptiveRefinement* recipe, const PieceReduction& pieces)
{
  View& view = this->Views.back();
  Dependencies state =
    Dependencies::On(this->Target, view.Limit, recipe->GetLevelOffset(), recipe->GetMaximumLevel());
  std::vector<TriangleBudget::Part> meshes;
  for (const Part& part : parts)
  {
    state.Add(part.Mesh.Family->GetMTime());
    state.Add(part.TagsTime);
    state.Add(part.SightTime);
    meshes.push_back(part.Mesh);
  }
  std::vector<double> changed(1, view.State != state ? 1.0 : 0.0);
  pieces.TakeLargest(changed);
  if (changed[0] > 0.0)
  {
    view.State = state;
    // A time limit lowers levels by at least a small amount, and never raises them.
    double offset = this->Target > 0 ? recipe->GetLevelOffsetMaxValue()
                                     : recipe->GetLevelOffset() - 0.5 / TriangleBudget::Resolution;
    const auto keepTo = [&](vtkIdType triangles, const PieceReduction& counted)
    {
      if (triangles > 0)
      {
        offset = this->Triangles.FindOffset(meshes, recipe->GetMaximumLevel(), triangles,
          recipe->GetLevelOffsetMinValue(), offset, view.Offset, counted);
      }
    };
    keepTo(this->Target, pieces);
    keepTo(view.Limit, PieceReduction()); // each process has its own time limit
    std::vector<double> negated(1, -offset);
    pieces.TakeLargest(negated);
    view.Offset = -negated[0];
  }
  return view.Offset - recipe->GetLevelOffset();
}
}
