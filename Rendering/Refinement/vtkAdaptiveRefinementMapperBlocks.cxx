// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// The blocks of a composite input, each of which has a mapper of its own.
#include "Composite/BlockAttributes.h"
#include "vtkAdaptiveRefinementMapperInternals.h"

#include "Checks/InputType.h"
#include "Checks/ShouldReport.h"
#include "vtkCommand.h"
#include "vtkCompositeDataSet.h"
#include "vtkPolyData.h"
#include "vtkRenderer.h"

bool vtkAdaptiveRefinementMapper::IsComposite()
{
  return vtkCompositeDataSet::SafeDownCast(this->GetInputDataObject(0, 0)) != nullptr;
}

bool vtkAdaptiveRefinementMapper::CheckInputType()
{
  vtkInternals& data = *this->Internals;
  vtkDataObject* input = this->GetTrueInput();
  if (data.CheckedInput != input)
  {
    data.CheckedInput = input;
    data.TypeProblem.clear();
  }
  vtkInformation* port = this->GetInputPortInformation(0);
  if (relevo::ShouldReport(data.TypeProblem, input ? relevo::FindTypeProblem(input, port) : ""))
  {
    vtkErrorMacro(<< data.TypeProblem);
  }
  const bool isValid = !input || relevo::IsOfRequiredType(input, port);
  if (!isValid)
  {
    data.Drawable = false; // the renderer leaves out what has no bounds
    data.NumberOfDrawCalls = 0;
  }
  return isValid;
}

bool vtkAdaptiveRefinementMapper::HasBlocks(bool translucent)
{
  if (this->GetNumberOfInputConnections(0) == 0)
  {
    return false;
  }
  // While blocks draw, they are those of the (sub-)piece that is drawn.
  const bool isRendering = this->Internals->Blocks.IsRendering();
  if (!isRendering && !this->GetInput())
  {
    this->Update(); // asked before it is drawn
  }
  bool found = false;
  if (this->IsComposite())
  {
    if (!isRendering)
    {
      this->UpdateBlocks();
    }
    this->ForEachBlock(
      [&](vtkAdaptiveRefinementMapper* block)
      {
        found = found ||
          (block->GetBlockAttributes().Visible &&
            block->HasTranslucentPolygonalGeometry() == translucent);
      });
  }
  return found;
}

bool vtkAdaptiveRefinementMapper::HasOpaqueGeometry()
{
  return this->HasBlocks(false) || (!this->IsComposite() && this->Superclass::HasOpaqueGeometry());
}

bool vtkAdaptiveRefinementMapper::HasTranslucentPolygonalGeometry()
{
  return this->HasBlocks(true) ||
    (!this->IsComposite() &&
      (this->GetBlockAttributes().IsTranslucent() ||
        this->Superclass::HasTranslucentPolygonalGeometry()));
}

void vtkAdaptiveRefinementMapper::RenderBlocks(vtkRenderer* ren, vtkActor* act)
{
  vtkInternals& data = *this->Internals;
  if (ren->GetRenderWindow()->CheckAbortStatus())
  {
    return;
  }
  this->InvokeEvent(vtkCommand::StartEvent, nullptr);
  if (!this->Static)
  {
    this->GetInputAlgorithm()->Update();
  }
  this->InvokeEvent(vtkCommand::EndEvent, nullptr);
  data.DrawsBlocks = true;
  this->UpdateBlocks();
  this->UpdateBudget(ren, act);
  data.Blocks.Render(ren, act, this->DrawsAllBlocks());
  this->UpdateProgress(1.0);
}

void vtkAdaptiveRefinementMapper::ReleaseMesh(vtkRenderer* ren)
{
  vtkInternals& data = *this->Internals;
  if (data.State.HasMesh())
  {
    data.State.Clear();
    data.Drawable = false;
    data.OnGPU = false;
    this->ReleaseGraphicsResources(ren->GetRenderWindow());
  }
}

void vtkAdaptiveRefinementMapper::UpdateBlocks()
{
  vtkInternals& data = *this->Internals;
  this->CheckInputType();
  data.Blocks.Update(this, vtkCompositeDataSet::SafeDownCast(this->GetInputDataObject(0, 0)));
  if (data.BlockSettingsTime != this->MTime)
  {
    data.BlockSettingsTime = this->MTime;
    this->ForEachBlock([this](vtkAdaptiveRefinementMapper* block) { block->CopySettings(this); });
  }
}

void vtkAdaptiveRefinementMapper::ForEachBlock(
  const std::function<void(vtkAdaptiveRefinementMapper*)>& work) const
{
  this->Internals->Blocks.ForEach([&work](vtkBlockAttributesPolyDataMapper* block)
    { work(static_cast<vtkAdaptiveRefinementMapper*>(block)); });
}

void vtkAdaptiveRefinementMapper::ForEachPart(
  const std::function<void(vtkAdaptiveRefinementMapper*)>& work)
{
  if (this->Internals->DrawsBlocks)
  {
    this->ForEachBlock(work);
  }
  else
  {
    work(this);
  }
}

void vtkAdaptiveRefinementMapper::vtkInternals::AddCounts(vtkAdaptiveRefinementMapper* block)
{
  this->State.AddSelections(block->GetNumberOfSelections());
  this->NumberOfBufferBuilds += block->GetNumberOfBufferBuilds();
  this->NumberOfShaderBuilds += block->GetNumberOfShaderBuilds();
}
