// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// The coarse mesh, its bounds, and which levels its faces take, on the CPU or the GPU.
#include "Actors/ActorView.h"
#include "Composite/BlockAttributes.h"
#include "vtkAdaptiveRefinementMapperInternals.h"

#include "Evaluation/FaceCulling.h"
#include "Parallel/PieceReduction.h"
#include "View/RefinementView.h"
#include "vtkActor.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkBoundingBox.h"
#include "vtkCamera.h"
#include "vtkDepthTagMetric.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRefinementPatternTable.h"
#include "vtkRenderer.h"
#include "vtkShaderProperty.h"
#include "vtkTexture.h"
#include "vtkTimerLog.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <memory>

bool vtkAdaptiveRefinementMapper::vtkInternals::IsFirstPass(vtkActor* act)
{
  return act->GetEstimatedRenderTime() == 0.0;
}

double vtkAdaptiveRefinementMapper::vtkInternals::GetAllocatedTime(vtkRenderer* ren, vtkActor* act)
{
  return std::min(act->GetAllocatedRenderTime(), ren->GetAllocatedRenderTime());
}

bool vtkAdaptiveRefinementMapper::Report(const relevo::StageResult& result)
{
  for (const std::string& error : result.Errors)
  {
    vtkErrorMacro(<< error);
  }
  for (const std::string& warning : result.Warnings)
  {
    vtkWarningMacro(<< warning);
  }
  return result.IsValid;
}

bool vtkAdaptiveRefinementMapper::ReportState(bool valid)
{
  const std::string error = this->Internals->State.TakeError();
  const std::string warning = this->Internals->State.TakeWarning();
  if (!error.empty())
  {
    vtkErrorMacro(<< error);
  }
  if (!warning.empty())
  {
    vtkWarningMacro(<< warning);
  }
  return valid;
}

bool vtkAdaptiveRefinementMapper::UpdateMesh()
{
  vtkPolyData* input = this->GetInput();
  return input && this->ReportState(this->Internals->State.UpdateMesh(input, this->Refinement));
}

bool vtkAdaptiveRefinementMapper::SelectsOnGPU()
{
  vtkInternals& data = *this->Internals;
  return data.ComputeValid && data.Methods.Get().TakesComputeSelection() &&
    !data.State.IsBudgeted && this->RefinementColorMode != COLOR_BY_METRIC &&
    relevo::RefinementComputeState::CanChooseFrom(
      *relevo::GetPatternFamily(this->Refinement, this->GetInput())) &&
    (data.FailedSelection.IsEmpty() || data.FailedSelection != data.GetSelectionSources(this));
}

relevo::Dependencies vtkAdaptiveRefinementMapper::vtkInternals::GetSelectionSources(
  vtkAdaptiveRefinementMapper* mapper) const
{
  vtkAdaptiveRefinement* recipe = mapper->Refinement;
  relevo::Dependencies sources = relevo::Dependencies::On(this->State.GetMeshTime(),
    relevo::GetPatternFamily(recipe, mapper->GetInput())->GetMTime(), recipe->GetMaximumLevel(),
    recipe->GetLevelRule());
  sources.AddObject(recipe->GetMetric());
  return sources;
}

namespace
{
// What a camera sees of a mesh; nullptr to draw all of it.
std::unique_ptr<relevo::CullingView> MakeCullingView(
  bool culled, vtkRenderer* ren, vtkActor* act, const relevo::RefinementMesh& mesh)
{
  if (!culled || relevo::MovesVertices(act))
  {
    return nullptr;
  }
  // Lines and points are drawn wider than they are.
  vtkProperty* property = act->GetProperty();
  double width = 0.0;
  if (property->GetRepresentation() != VTK_SURFACE || property->GetVertexVisibility())
  {
    width = std::max(property->GetLineWidth(), property->GetPointSize());
  }
  return std::make_unique<relevo::CullingView>(ren->GetActiveCamera(), ren->GetTiledAspectRatio(),
    act->GetMatrix(), mesh.Origin, relevo::GetViewMargins(ren, width));
}

// Whether an actor drawn as opaque lets through what is behind it in some places.
bool HasGaps(vtkActor* act)
{
  vtkTexture* texture = act->GetTexture();
  vtkImageData* image = texture ? texture->GetInput() : nullptr;
  vtkShaderProperty* shaders = act->GetShaderProperty();
  return act->GetForceOpaque() || act->GetProperty()->GetOpacity() < 1.0 ||
    act->GetProperty()->GetTexture("albedoTex") ||
    (texture && (!image || image->GetNumberOfScalarComponents() != 3)) ||
    shaders->HasFragmentShaderCode() || shaders->GetNumberOfShaderReplacements() > 0;
}

// VTK calls some colours opaque that are not, as those of vectors of four components. It draws
// them with its opaque surfaces, and yet lets through what is behind.
bool LetsThrough(vtkUnsignedCharArray* colors)
{
  return colors && colors->GetNumberOfComponents() == 4 && colors->GetNumberOfTuples() > 0 &&
    colors->GetRange(3)[0] < 255.0;
}
}

bool vtkAdaptiveRefinementMapper::UpdateSelection(vtkRenderer* ren, vtkActor* act)
{
  vtkInternals& data = *this->Internals;
  const relevo::RefinementView view = relevo::MakeActorView(ren, act);
  const auto culling = MakeCullingView(this->FrustumCulling, ren, act, data.State.GetMesh());
  return this->ReportState(data.State.UpdateSelection(this->GetInput(), this->Refinement, view,
    culling.get(), this->HidesBackFaces(ren, act), data.OnGPU));
}

void vtkAdaptiveRefinementMapper::UpdateBudget(
  vtkRenderer* ren, vtkActor* act, const relevo::PieceReduction* pieces)
{
  vtkInternals& data = *this->Internals;
  if (data.IsBlock || (data.AgreesWithProcesses && !pieces))
  {
    return;
  }
  double seconds = 0.0;
  if (this->UseAllocatedRenderTime)
  {
    // What has been seen is picked, and later passes show what the first has shown. Before a frame,
    // the actor has not been allotted its time yet.
    seconds = ren->GetSelector()       ? -1.0
      : pieces                         ? ren->GetAllocatedRenderTime()
      : vtkInternals::IsFirstPass(act) ? vtkInternals::GetAllocatedTime(ren, act)
                                       : -1.0;
  }
  std::vector<double> budgets(1, data.Budget.SetView(ren->GetActiveCamera(), seconds) ? 1.0 : 0.0);
  const relevo::PieceReduction alone;
  const relevo::PieceReduction& all = pieces ? *pieces : alone;
  all.TakeLargest(budgets);
  const bool isBudgeted = budgets[0] > 0.0;
  const relevo::RefinementView view = relevo::MakeActorView(ren, act);
  std::vector<relevo::LevelBudget::Part> parts;
  const auto addPart = [&](vtkAdaptiveRefinementMapper* mapper)
  {
    relevo::RefinementState& state = mapper->Internals->State;
    state.IsBudgeted = isBudgeted;
    if (isBudgeted && mapper->GetBlockAttributes().Visible && mapper->UpdateMesh() &&
      state.UpdateTags(mapper->GetInput(), this->Refinement, view, false))
    {
      const auto culling = MakeCullingView(this->FrustumCulling, ren, act, state.GetMesh());
      state.UpdateSight(this->Refinement, culling.get(), mapper->CanHideBackFaces(act));
      const relevo::ViewSelection& selection = state.GetSelection();
      parts.push_back(
        { { &state.GetMesh(), &selection.GetTags(),
            relevo::GetPatternFamily(this->Refinement, mapper->GetInput()), selection.GetHidden() },
          selection.GetTagsTime(), selection.GetSightTime() });
    }
  };
  if (data.Blocks.IsEmpty())
  {
    addPart(this);
  }
  this->ForEachBlock(addPart);
  const bool isSought = isBudgeted && this->Refinement && (pieces || !parts.empty());
  const double offset = isSought ? data.Budget.FindOffset(parts, this->Refinement, all) : 0.0;
  const auto setOffset = [&](vtkAdaptiveRefinementMapper* mapper)
  {
    mapper->Internals->State.LevelOffset = offset;
    mapper->Internals->IsBlock = mapper != this;
  };
  setOffset(this);
  this->ForEachBlock(setOffset);
}

bool vtkAdaptiveRefinementMapper::SelectOnGPU(vtkRenderer* ren, vtkActor* act)
{
  vtkInternals& data = *this->Internals;
  vtkOpenGLRenderWindow* window = vtkOpenGLRenderWindow::SafeDownCast(ren->GetRenderWindow());
  const double start = vtkTimerLog::GetUniversalTime();
  const relevo::RefinementMesh& mesh = data.State.GetMesh();
  const auto family = relevo::GetPatternFamily(this->Refinement, this->GetInput());
  const int slot = data.State.GetSelectionSlot();
  const vtkMTimeType lastTime = data.Compute.GetTime(slot);
  const relevo::ViewSelection& selection = data.State.GetSelection();
  const auto camera = MakeCullingView(this->FrustumCulling, ren, act, mesh);
  const relevo::FaceCulling* culled = camera ? &data.State.GetCulling(this->Refinement) : nullptr;
  const bool reserved =
    data.Upload.GetInstances().Reserve(window, slot, mesh.Faces.size(), family->IsMorphing());
  const bool valid = reserved && data.Compute.UpdateMesh(mesh, data.State.GetMeshTime()) &&
    (!culled || data.Compute.UpdateCulling(*culled, data.State.GetCullingTime())) &&
    data.Compute.UpdatePatterns(*this->Refinement->GetPatternTable()->GetLibrary(), family,
      this->Refinement->GetMaximumLevel(), data.Upload.GetPatterns(),
      act->GetProperty()->GetRepresentation() == VTK_WIREFRAME) &&
    data.Compute.UpdateView(window, slot, selection.GetTags(),
      static_cast<float>(this->Refinement->GetLevelOffset() + data.State.LevelOffset),
      selection.GetLevelsTime(), camera.get(),
      culled && culled->HidesBackFaces(*camera, this->HidesBackFaces(ren, act)),
      data.Upload.GetTargets());
  if (data.Compute.GetTime(slot) != lastTime)
  {
    data.ComputeSeconds = vtkTimerLog::GetUniversalTime() - start;
  }
  this->ReportSelection(valid ? ""
      : reserved              ? data.Compute.GetError()
                              : relevo::BufferTexture::GetTooLarge());
  return valid;
}

void vtkAdaptiveRefinementMapper::ReportSelection(const std::string& problem)
{
  vtkInternals& data = *this->Internals;
  data.FailedSelection = problem.empty() ? relevo::Dependencies() : data.GetSelectionSources(this);
  const bool isNew = problem != data.SelectionProblem;
  data.SelectionProblem = problem;
  if (problem.empty() || !isNew)
  {
    return;
  }
  if (this->SelectionDevice == SELECTION_DEVICE_GPU)
  {
    vtkErrorMacro("Selection on the GPU failed: " << problem << ". It is done on the CPU.");
  }
  else
  {
    vtkWarningMacro("Selection on the GPU failed: " << problem << ". It is done on the CPU.");
  }
}

void vtkAdaptiveRefinementMapper::ReadSelection()
{
  vtkInternals& data = *this->Internals;
  const int slot = data.State.GetSelectionSlot();
  const vtkMTimeType time = data.OnGPU && data.GetWindow() ? data.Compute.GetTime(slot) : 0;
  if (time == 0 || time == data.ReadTime)
  {
    return;
  }
  data.ReadTime = time;
  data.GetWindow()->PushContext();
  const relevo::RefinementMesh& mesh = data.State.GetSelection().GetMesh();
  std::vector<float> morphTags;
  if (data.Upload.GetInstances().GetMorphTags())
  {
    morphTags.resize(3 * mesh.Faces.size());
    relevo::RefinementComputeBuffer::ReadBuffer(data.Upload.GetInstances().GetMorphTags(), 0,
      morphTags.data(), morphTags.size() * sizeof(float));
  }
  data.State.AssignSelection(*data.Compute.GetFamily(), data.Compute.ReadEntries(slot),
    std::move(morphTags), data.Compute.ReadHidden(slot));
  const std::vector<int> counts = data.Compute.ReadCounts(slot);
  data.GetWindow()->PopContext();
  // Two keys share a pattern, of which one turns it over.
  data.NumberOfUsedPatterns = 0;
  for (size_t key = 0; key + 1 < counts.size(); key += 2)
  {
    data.NumberOfUsedPatterns += counts[key] + counts[key + 1] > 0 ? 1 : 0;
  }
}

bool vtkAdaptiveRefinementMapper::HidesBackFaces(vtkRenderer* ren, vtkActor* act)
{
  return !ren->GetSelector() && !act->IsRenderingTranslucentPolygonalGeometry() &&
    this->CanHideBackFaces(act);
}

bool vtkAdaptiveRefinementMapper::CanHideBackFaces(vtkActor* act)
{
  vtkProperty* property = act->GetProperty();
  return this->BackFaceCulling && this->Method != METHOD_ARK &&
    property->GetRepresentation() == VTK_SURFACE && !property->GetFrontfaceCulling() &&
    !property->GetVertexVisibility() && !property->GetEdgeVisibility() &&
    !this->HasTranslucentPolygonalGeometry() && !HasGaps(act) && !LetsThrough(this->Colors) &&
    !relevo::MovesVertices(act) && this->GetNumberOfClippingPlanes() == 0 &&
    act->GetMatrix()->Determinant() > 0.0;
}

void vtkAdaptiveRefinementMapper::ComputeBounds()
{
  vtkInternals& data = *this->Internals;
  if (this->IsComposite())
  {
    this->UpdateBlocks();
    vtkBoundingBox box;
    this->ForEachBlock(
      [&box](vtkAdaptiveRefinementMapper* block)
      {
        if (block->GetBlockAttributes().Visible)
        {
          box.AddBounds(block->GetBounds());
        }
      });
    vtkMath::UninitializeBounds(this->Bounds);
    if (box.IsValid())
    {
      box.GetBounds(this->Bounds);
    }
    return;
  }
  data.Blocks.Clear();
  if (!this->CheckInputType() || !this->UpdateMesh())
  {
    // Bounds of the points alone: vtkPolyData does not check what cells refer to.
    vtkPoints* points = this->GetInput() ? this->GetInput()->GetPoints() : nullptr;
    vtkMath::UninitializeBounds(this->Bounds);
    if (points && points->GetNumberOfPoints() > 0)
    {
      points->GetBounds(this->Bounds);
    }
    return;
  }
  data.State.GetBounds(this->Refinement, this->Bounds);
}
