// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkReliefMapperInternals.h"

#include "Core/SettingChecks.h"
#include "vtkActor.h"
#include "vtkBoundingBox.h"
#include "vtkCommand.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkExecutive.h"
#include "vtkHardwareSelector.h"
#include "vtkInformation.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"

#include <limits>

namespace
{
// What the reliefs of an input were made from.
relevo::Dependencies GetSource(vtkDataObject* input)
{
  relevo::Dependencies source;
  source.AddObject(input, input ? input->GetMTime() : 0);
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(input))
  {
    auto leaf = vtk::TakeSmartPointer(composite->NewIterator());
    for (leaf->InitTraversal(); !leaf->IsDoneWithTraversal(); leaf->GoToNextItem())
    {
      source.AddObject(leaf->GetCurrentDataObject());
    }
  }
  return source;
}
}

vtkStandardNewMacro(vtkReliefMapper);

vtkReliefMapper::vtkReliefMapper()
  : Internals(new vtkInternals)
{
  this->Internals->Context->OnRelease = [this](vtkWindow* window)
  { this->ReleaseGraphicsResources(window); };
}

vtkReliefMapper::~vtkReliefMapper()
{
  // While virtual calls still reach this class, and in the context of the window.
  this->ReleaseGraphicsResources(nullptr);
}

int vtkReliefMapper::FillInputPortInformation(int, vtkInformation* info)
{
  info->Remove(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE());
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

void vtkReliefMapper::SetInputData(vtkImageData* relief)
{
  this->SetInputDataInternal(0, relief);
}

void vtkReliefMapper::SetMethod(int method)
{
  relevo::SetChoice(this, "Method", this->Method, method, { "RAY_MARCH", "REFINEMENT" });
}

void vtkReliefMapper::SetSearch(int search)
{
  relevo::SetChoice(this, "Search", this->Search, search,
    { "LINEAR_BINARY", "LINEAR_SECANT", "RELAXED_CONES", "MAXIMUM_MIPMAP" });
}

void vtkReliefMapper::SetShading(int shading)
{
  relevo::SetChoice(this, "Shading", this->Shading, shading, { "CAPTURED", "LIT" });
}

void vtkReliefMapper::SetMaximumStretch(double stretch)
{
  relevo::SetInRange(
    this, "MaximumStretch", this->MaximumStretch, stretch, 0.0, std::numeric_limits<double>::max());
}

//------------------------------------------------------------------------------
// Input

void vtkReliefMapper::UpdateBlocks()
{
  vtkInternals& data = *this->Internals;
  vtkDataObject* input =
    this->GetNumberOfInputConnections(0) > 0 ? this->GetInputDataObject(0, 0) : nullptr;
  relevo::Dependencies source = GetSource(input);
  source.Add(this->MaximumStretch);
  if (!data.Source.Update(source))
  {
    return;
  }
  std::map<unsigned int, vtkInternals::Block> blocks;
  for (relevo::ReliefBlock& relief :
    input ? relevo::ReadReliefs(input) : std::vector<relevo::ReliefBlock>())
  {
    const unsigned int index = relief.FlatIndex;
    vtkInternals::Block& block = blocks[index];
    const auto last = data.Blocks.find(index);
    if (last != data.Blocks.end())
    {
      block = last->second;
    }
    relevo::Dependencies own;
    own.AddObject(relief.Data.GetImage());
    own.Add(this->MaximumStretch);
    block.Relief = relief;
    if (!relief.Fault.empty())
    {
      if (relief.Fault != block.Problem)
      {
        vtkErrorMacro(<< relief.Fault);
      }
      block.Problem = relief.Fault;
      block.Source.Clear();
      continue;
    }
    block.Problem.clear();
    block.Painter = block.Painter ? block.Painter : vtkSmartPointer<relevo::ReliefPainter>::New();
    if (block.Source.Update(own))
    {
      block.Painter->SetRelief(relief.Data, this->MaximumStretch);
    }
  }
  for (auto& last : data.Blocks)
  {
    if (!blocks.count(last.first) && last.second.Painter)
    {
      data.NumberOfBufferBuilds += last.second.Painter->GetNumberOfBufferBuilds();
      data.NumberOfShaderBuilds += last.second.Painter->GetNumberOfShaderBuilds();
      last.second.Painter->ReleaseGraphicsResources(data.Context->GetContext());
    }
  }
  data.Blocks.swap(blocks);
}

double* vtkReliefMapper::GetBounds()
{
  vtkMath::UninitializeBounds(this->Bounds);
  if (this->GetNumberOfInputConnections(0) == 0)
  {
    return this->Bounds;
  }
  if (!this->Static)
  {
    this->GetInputAlgorithm()->Update();
  }
  this->UpdateBlocks();
  vtkBoundingBox box;
  for (const auto& block : this->Internals->Blocks)
  {
    if (block.second.Problem.empty() &&
      vtkMath::AreBoundsInitialized(block.second.Painter->GetSurfaceBounds()))
    {
      box.AddBounds(block.second.Painter->GetSurfaceBounds());
    }
  }
  if (box.IsValid())
  {
    box.GetBounds(this->Bounds);
  }
  return this->Bounds;
}

bool vtkReliefMapper::HasTranslucentPolygonalGeometry()
{
  this->GetBounds(); // which reads the input
  for (const auto& block : this->Internals->Blocks)
  {
    if (block.second.Problem.empty() && block.second.Painter->IsTranslucent())
    {
      return true;
    }
  }
  return false;
}

bool vtkReliefMapper::HasOpaqueGeometry()
{
  return !this->HasTranslucentPolygonalGeometry();
}

//------------------------------------------------------------------------------
// Rendering

void vtkReliefMapper::Render(vtkRenderer* renderer, vtkActor* actor)
{
  vtkRenderWindow* window = renderer->GetRenderWindow();
  if (window->CheckAbortStatus())
  {
    return;
  }
  if (this->GetNumberOfInputConnections(0) == 0)
  {
    vtkErrorMacro("There is no input.");
    return;
  }
  this->InvokeEvent(vtkCommand::StartEvent, nullptr);
  if (!this->Static)
  {
    this->GetInputAlgorithm()->Update();
  }
  this->InvokeEvent(vtkCommand::EndEvent, nullptr);
  // Releases what is in the context of another window.
  this->Internals->Context->SetContext(vtkOpenGLRenderWindow::SafeDownCast(window));
  this->UpdateBlocks();
  this->RenderBlocks(renderer, actor);
  this->UpdateProgress(1.0);
}

void vtkReliefMapper::RenderBlocks(vtkRenderer* renderer, vtkActor* actor)
{
  vtkHardwareSelector* selector = renderer->GetSelector();
  if (selector)
  {
    selector->BeginRenderProp();
  }
  relevo::ReliefPainter::Settings settings;
  settings.Method = static_cast<relevo::ReliefShaderOptions::Methods>(this->Method);
  settings.Search = this->Search;
  settings.IsLit = this->Shading == LIT;
  for (auto& entry : this->Internals->Blocks)
  {
    vtkInternals::Block& block = entry.second;
    if (!block.Relief.Fault.empty())
    {
      continue;
    }
    const std::string problem = block.Painter->Prepare(renderer, settings);
    if (problem != block.Problem)
    {
      block.Problem = problem;
      if (!problem.empty())
      {
        vtkErrorMacro(<< block.Relief.Describe(problem));
      }
    }
    if (!problem.empty())
    {
      continue;
    }
    block.Painter->SetClippingPlanes(this->ClippingPlanes);
    if (selector)
    {
      block.Painter->AnnounceIds(selector);
      if (selector->GetCurrentPass() == vtkHardwareSelector::COMPOSITE_INDEX_PASS)
      {
        selector->RenderCompositeIndex(std::max(entry.first, 1u));
      }
    }
    block.Painter->RenderPiece(renderer, actor);
  }
  if (selector)
  {
    selector->EndRenderProp();
  }
}

void vtkReliefMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  vtkInternals& data = *this->Internals;
  if (data.Context->Release())
  {
    return; // came back to this method, from within the context that the resources belong to
  }
  this->Superclass::ReleaseGraphicsResources(window);
  for (auto& block : data.Blocks)
  {
    if (block.second.Painter)
    {
      block.second.Painter->ReleaseGraphicsResources(window);
    }
  }
}

//------------------------------------------------------------------------------

vtkTypeInt64 vtkReliefMapper::GetGraphicsMemorySize()
{
  vtkTypeInt64 size = 0;
  for (const auto& block : this->Internals->Blocks)
  {
    size += block.second.Painter ? block.second.Painter->GetMemorySize() : 0;
  }
  return size;
}

vtkIdType vtkReliefMapper::GetNumberOfBufferBuilds()
{
  vtkIdType number = this->Internals->NumberOfBufferBuilds;
  for (const auto& block : this->Internals->Blocks)
  {
    number += block.second.Painter ? block.second.Painter->GetNumberOfBufferBuilds() : 0;
  }
  return number;
}

vtkIdType vtkReliefMapper::GetNumberOfShaderBuilds()
{
  vtkIdType number = this->Internals->NumberOfShaderBuilds;
  for (const auto& block : this->Internals->Blocks)
  {
    number += block.second.Painter ? block.second.Painter->GetNumberOfShaderBuilds() : 0;
  }
  return number;
}

void vtkReliefMapper::ShallowCopy(vtkAbstractMapper* mapper)
{
  if (vtkReliefMapper* other = vtkReliefMapper::SafeDownCast(mapper))
  {
    this->SetMethod(other->Method);
    this->SetSearch(other->Search);
    this->SetShading(other->Shading);
    this->SetMaximumStretch(other->MaximumStretch);
    this->SetInputConnection(other->GetInputConnection(0, 0));
  }
  this->Superclass::ShallowCopy(mapper);
}

void vtkReliefMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Method: " << this->Method << "\n";
  os << indent << "Search: " << this->Search << "\n";
  os << indent << "Shading: " << this->Shading << "\n";
  os << indent << "MaximumStretch: " << this->MaximumStretch << "\n";
}
