// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// What the mappers of several processes agree on, each of which has pieces of the same surfaces.
#include "Actors/ActorView.h"
#include "vtkAdaptiveRefinementMapperInternals.h"

#include "Evaluation/SampledSurface.h"
#include "Metrics/MetricCache.h"
#include "Metrics/PieceAgreement.h"
#include "Parallel/GlobalSurfaceInfo.h"
#include "Parallel/ProcessReduction.h"
#include "vtkActor.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkDepthTagMetric.h"
#include "vtkMatrix4x4.h"
#include "vtkMultiProcessController.h"
#include "vtkPolyData.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <map>
#include <memory>
#include <set>
#include <utility>
#include <vector>

std::map<unsigned int, vtkAdaptiveRefinementMapper*>
vtkAdaptiveRefinementMapper::vtkInternals::FindParts(vtkAdaptiveRefinementMapper* mapper)
{
  std::map<unsigned int, vtkAdaptiveRefinementMapper*> parts;
  if (mapper->GetNumberOfInputConnections(0) == 0)
  {
    return parts;
  }
  mapper->Update();
  if (mapper->IsComposite())
  {
    mapper->UpdateBlocks();
    for (unsigned int index : mapper->Internals->Blocks.GetFlatIndices())
    {
      parts[index] =
        static_cast<vtkAdaptiveRefinementMapper*>(mapper->Internals->Blocks.Find(index));
    }
  }
  else if (mapper->GetInput())
  {
    parts[0] = mapper;
  }
  return parts;
}

// What a piece, nullptr where this process has none, and those of other processes are together.
void vtkAdaptiveRefinementMapper::vtkInternals::AgreeOnWhole(vtkAdaptiveRefinement* recipe,
  vtkAdaptiveRefinementMapper* part, const relevo::RefinementView& view,
  const relevo::PieceReduction& pieces)
{
  relevo::RefinementState none;
  relevo::RefinementState& state = part ? part->Internals->State : none;
  vtkNew<vtkPolyData> empty;
  vtkPolyData* mesh = part ? part->GetInput() : empty.Get();
  const auto whole = std::make_shared<relevo::GlobalSurfaceInfo>();
  if (state.GetWhole())
  {
    *whole = *state.GetWhole();
  }
  whole->HasDirections = false;
  relevo::AgreeOnPoints(mesh, pieces, *whole);
  state.SetWhole(std::make_shared<relevo::GlobalSurfaceInfo>(*whole)); // what it is built by

  if (part && !part->UpdateMesh())
  {
    mesh = empty;
  }
  whole->HasDirections = !state.GetMesh().Directions.empty();
  relevo::MetricCache source; // what is known of an invalid mesh is not to be asked for
  relevo::AgreeOnShape(
    mesh, mesh == empty ? source : state.GetTagSource(), recipe->GetMetric(), view, pieces, *whole);
  state.SetWhole(whole);
}

void vtkAdaptiveRefinementMapper::AgreeWithProcesses(
  vtkMultiProcessController* controller, vtkRenderer* ren, vtkActor* act)
{
  vtkInternals& data = *this->Internals;
  data.AgreesWithProcesses = controller && controller->GetNumberOfProcesses() > 1;
  if (!data.AgreesWithProcesses && data.WholeDependencies.IsEmpty())
  {
    return;
  }
  std::map<unsigned int, vtkAdaptiveRefinementMapper*> parts = vtkInternals::FindParts(this);
  if (!data.AgreesWithProcesses || !this->Refinement)
  {
    data.WholeDependencies.Clear();
    for (const auto& part : parts)
    {
      part.second->Internals->State.SetWhole(nullptr);
    }
    return;
  }
  relevo::RefinementView view = relevo::MakeActorView(ren, act);
  view.Displaced = relevo::SampledSurface::Make(this->Refinement);
  relevo::Dependencies now;
  now.AddObject(this->Refinement.Get());
  vtkDepthTagMetric* metric = this->Refinement->GetMetric();
  if (metric && metric->IsPlacementDependent())
  {
    std::for_each(view.ModelToWorld->GetData(), view.ModelToWorld->GetData() + 16,
      [&now](double value) { now.Add(value); });
  }
  std::vector<double> indices;
  for (const auto& part : parts)
  {
    now.Add(part.first);
    now.AddObject(part.second->GetInput());
    indices.push_back(part.first);
  }
  const relevo::ProcessReduction pieces(controller);
  std::vector<double> changed(1, data.WholeDependencies.Update(now) ? 1.0 : 0.0);
  pieces.TakeLargest(changed);
  if (changed[0] > 0.0)
  {
    indices = pieces.Collect(std::move(indices));
    for (double index : std::set<double>(indices.begin(), indices.end()))
    {
      const auto part = parts.find(static_cast<unsigned int>(index));
      vtkInternals::AgreeOnWhole(
        this->Refinement, part == parts.end() ? nullptr : part->second, view, pieces);
    }
  }
  this->UpdateBudget(ren, act, &pieces);
}
