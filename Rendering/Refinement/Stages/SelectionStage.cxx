// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Stages/SelectionStage.h"

#include "Checks/ShouldReport.h"
#include "Evaluation/FaceCulling.h"
#include "Recipe/RecipeLevels.h"
#include "Stages/UploadStage.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkDepthTagMetric.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPolyData.h"
#include "vtkRefinementPatternTable.h"
#include "vtkTimerLog.h"

#include <utility>

namespace relevo
{
StageResult SelectionStage::TakeResult(bool isValid)
{
  StageResult result;
  result.IsValid = isValid;
  const std::string error = this->State.TakeError();
  const std::string warning = this->State.TakeWarning();
  if (!error.empty())
  {
    result.Errors.push_back(error);
  }
  if (!warning.empty())
  {
    result.Warnings.push_back(warning);
  }
  return result;
}

StageResult SelectionStage::UpdateMesh(vtkPolyData* input, vtkAdaptiveRefinement* recipe)
{
  return this->TakeResult(this->State.UpdateMesh(input, recipe));
}

void SelectionStage::AddBudgetPart(const ViewInput& input, std::vector<LevelBudget::Part>& parts)
{
  if (this->State.UpdateTags(input.Mesh, input.Recipe, input.View, false))
  {
    this->State.UpdateSight(input.Recipe, input.Culling, input.HidesBackFaces);
    const ViewSelection& selection = this->State.GetSelection();
    parts.push_back({ { &this->State.GetMesh(), &selection.GetTags(),
                        GetPatternFamily(input.Recipe, input.Mesh), selection.GetHidden() },
      selection.GetTagsTime(), selection.GetSightTime() });
  }
}

Dependencies SelectionStage::GetSources(const Input& input) const
{
  vtkAdaptiveRefinement* recipe = input.Recipe;
  Dependencies sources =
    Dependencies::On(this->State.GetMeshTime(), GetPatternFamily(recipe, input.Mesh)->GetMTime(),
      recipe->GetMaximumLevel(), recipe->GetLevelRule());
  sources.AddObject(recipe->GetMetric());
  return sources;
}

StageResult SelectionStage::UpdateState(const Input& input)
{
  return this->TakeResult(this->State.UpdateSelection(
    input.Mesh, input.Recipe, input.View, input.Culling, input.HidesBackFaces, this->OnGPU));
}

StageResult SelectionStage::Update(const Input& input)
{
  this->OnGPU = input.CanCompute && !this->State.IsBudgeted &&
    RefinementComputeState::CanChooseFrom(*GetPatternFamily(input.Recipe, input.Mesh)) &&
    (this->FailedSources.IsEmpty() || this->FailedSources != this->GetSources(input));
  return this->UpdateState(input);
}

StageResult SelectionStage::UpdateOnGPU(const Input& input, UploadStage& upload)
{
  if (!this->OnGPU)
  {
    return {};
  }
  std::string error;
  this->OnGPU = this->Select(input, upload, error);
  this->FailedSources = error.empty() ? Dependencies() : this->GetSources(input);
  const bool isNew = ShouldReport(this->Error, error);
  if (this->OnGPU)
  {
    return {};
  }
  StageResult result = this->UpdateState(input);
  if (isNew)
  {
    const std::string message =
      "Selection on the GPU failed: " + error + ". The CPU is used instead.";
    auto& messages = input.Device == SELECTION_DEVICE_GPU ? result.Errors : result.Warnings;
    messages.insert(messages.begin(), message);
  }
  return result;
}

bool SelectionStage::Select(const Input& input, UploadStage& upload, std::string& error)
{
  const double start = vtkTimerLog::GetUniversalTime();
  const RefinementMesh& mesh = this->State.GetMesh();
  const auto family = GetPatternFamily(input.Recipe, input.Mesh);
  const int slot = this->State.GetSelectionSlot();
  const vtkMTimeType lastTime = this->Compute.GetTime(slot);
  const ViewSelection& selection = this->State.GetSelection();
  const FaceCulling* culled = input.Culling ? &this->State.GetCulling(input.Recipe) : nullptr;
  if (!upload.GetInstances().Reserve(input.Window, slot, mesh.Faces.size(), family->IsMorphing()))
  {
    error = BufferTexture::GetTooLarge();
    return false;
  }
  const bool isValid = this->Compute.UpdateMesh(mesh, this->State.GetMeshTime()) &&
    (!culled || this->Compute.UpdateCulling(*culled, this->State.GetCullingTime())) &&
    this->Compute.UpdatePatterns(*input.Recipe->GetPatternTable()->GetLibrary(), family,
      input.Recipe->GetMaximumLevel(), upload.GetPatterns(), input.HasLines) &&
    this->Compute.UpdateView(input.Window, slot, selection.GetTags(),
      static_cast<float>(input.Recipe->GetLevelOffset() + this->State.LevelOffset),
      selection.GetLevelsTime(), input.Culling,
      culled && culled->HidesBackFaces(*input.Culling, input.HidesBackFaces), upload.GetTargets());
  if (this->Compute.GetTime(slot) != lastTime)
  {
    this->ComputeSeconds = vtkTimerLog::GetUniversalTime() - start;
  }
  error = isValid ? "" : this->Compute.GetError();
  return isValid;
}

RefinementComputeView* SelectionStage::GetComputeView()
{
  return this->OnGPU ? &this->Compute.GetView(this->State.GetSelectionSlot()) : nullptr;
}

void SelectionStage::ReadBack(vtkOpenGLRenderWindow* window, const InstanceBuffers& instances)
{
  const int slot = this->State.GetSelectionSlot();
  const vtkMTimeType time = this->OnGPU && window ? this->Compute.GetTime(slot) : 0;
  if (time == 0 || time == this->ReadTime)
  {
    return;
  }
  this->ReadTime = time;
  window->PushContext();
  std::vector<float> morphTags;
  if (instances.GetMorphTags())
  {
    morphTags.resize(3 * this->State.GetSelection().GetMesh().Faces.size());
    RefinementComputeBuffer::ReadBuffer(
      instances.GetMorphTags(), 0, morphTags.data(), morphTags.size() * sizeof(float));
  }
  this->State.AssignSelection(*this->Compute.GetFamily(), this->Compute.ReadEntries(slot),
    std::move(morphTags), this->Compute.ReadHidden(slot));
  const std::vector<int> counts = this->Compute.ReadCounts(slot);
  window->PopContext();
  // Two keys share a pattern; one of them mirrors it.
  this->NumberOfUsedPatterns = 0;
  for (size_t key = 0; key + 1 < counts.size(); key += 2)
  {
    this->NumberOfUsedPatterns += counts[key] + counts[key + 1] > 0 ? 1 : 0;
  }
}

int SelectionStage::CountUsedPatterns() const
{
  if (this->OnGPU)
  {
    return this->NumberOfUsedPatterns;
  }
  int count = 0;
  const auto& groups = this->State.GetSelection().GetSelection().Groups;
  for (size_t i = 0; i < groups.size(); ++i)
  {
    count += i == 0 || groups[i].Pattern != groups[i - 1].Pattern;
  }
  return count;
}

double SelectionStage::GetSeconds() const
{
  return this->State.GetSelection().GetSeconds() + (this->OnGPU ? this->ComputeSeconds : 0.0);
}

void SelectionStage::ReleaseGraphicsResources()
{
  this->Error.clear();
  this->FailedSources.Clear();
  this->Compute.ReleaseGraphicsResources();
  if (this->OnGPU)
  {
    this->State.ForgetLevels(); // the metric's data for the GPU may be out of date
  }
}
}
