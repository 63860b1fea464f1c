// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Stages/ProcessAgreement.h"

#include "Evaluation/SampledSurface.h"
#include "Metrics/MetricCache.h"
#include "Metrics/PieceAgreement.h"
#include "Parallel/GlobalSurfaceInfo.h"
#include "Parallel/PieceReduction.h"
#include "State/RefinementState.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkDepthTagMetric.h"
#include "vtkMultiProcessController.h"
#include "vtkPolyData.h"

#include <memory>
#include <set>
#include <utility>
#include <vector>

namespace relevo
{
namespace
{
// Share the data of the whole surface, of which `part` is this process's piece; nullptr if it has
// none.
void AgreeOnWhole(vtkAdaptiveRefinement* recipe, const ProcessAgreementPart* part,
  const RefinementView& view, const PieceReduction& pieces)
{
  RefinementState none;
  RefinementState& state = part ? *part->State : none;
  vtkNew<vtkPolyData> empty;
  vtkPolyData* mesh = part ? part->Input : empty.Get();
  const auto whole = std::make_shared<GlobalSurfaceInfo>();
  if (state.GetWhole())
  {
    *whole = *state.GetWhole();
  }
  whole->HasDirections = false;
  AgreeOnPoints(mesh, pieces, *whole);
  state.SetWhole(std::make_shared<GlobalSurfaceInfo>(*whole)); // the mesh is built with it

  if (part && !part->UpdateMesh())
  {
    mesh = empty;
  }
  whole->HasDirections = !state.GetMesh().Directions.empty();
  MetricCache unknown; // of an invalid mesh
  AgreeOnShape(mesh, mesh == empty ? unknown : state.GetMetricCache(), recipe->GetMetric(), view,
    pieces, *whole);
  state.SetWhole(whole);
}
}

bool ProcessAgreement::SetController(vtkMultiProcessController* controller)
{
  this->Active = controller && controller->GetNumberOfProcesses() > 1;
  return this->Active;
}

void ProcessAgreement::Clear(const Parts& parts)
{
  this->WholeDependencies.Clear();
  for (const auto& part : parts)
  {
    part.second.State->SetWhole(nullptr);
  }
}

void ProcessAgreement::Update(vtkAdaptiveRefinement* recipe, RefinementView view,
  const Parts& parts, const PieceReduction& pieces)
{
  view.Displaced = SampledSurface::Make(recipe);
  Dependencies now;
  now.AddObject(recipe);
  vtkDepthTagMetric* metric = recipe->GetMetric();
  view.AddTo(now, metric && metric->IsPlacementDependent(), false);
  std::vector<double> indices;
  for (const auto& part : parts)
  {
    now.Add(part.first);
    now.AddObject(part.second.Input);
    indices.push_back(part.first);
  }
  std::vector<double> changed(1, this->WholeDependencies.Update(now) ? 1.0 : 0.0);
  pieces.TakeLargest(changed);
  if (changed[0] > 0.0)
  {
    indices = pieces.Collect(std::move(indices));
    for (double index : std::set<double>(indices.begin(), indices.end()))
    {
      const auto part = parts.find(static_cast<unsigned int>(index));
      AgreeOnWhole(recipe, part == parts.end() ? nullptr : &part->second, view, pieces);
    }
  }
}
}
