// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Blocks/RefinementBlocks.h"

#include "Checks/InputType.h"
#include "Composite/BlockAttributes.h"
#include "Composite/LeafSelection.h"
#include "vtkActor.h"
#include "vtkBlockAttributesPolyDataMapper.h"
#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkHardwareSelector.h"
#include "vtkNew.h"
#include "vtkRenderer.h"

#include <set>

namespace relevo
{
namespace
{
// Return the argument of VTK's macros, without the file and the object's address before it.
std::string GetMessage(const std::string& text)
{
  const size_t colon = text.find("): ");
  return colon == std::string::npos ? text : text.substr(colon);
}
}

RefinementBlocks::RefinementBlocks() = default;
RefinementBlocks::~RefinementBlocks() = default;

void RefinementBlocks::Update(const Source& source)
{
  vtkBlockAttributesPolyDataMapper* parent = source.Parent;
  this->Parent = parent;
  this->Messages.clear();
  const bool changed = this->ParentTime != source.GetBuildTime();
  std::set<unsigned int> indices;
  vtkInformation* port = parent->GetInputPortInformation(0);
  auto iterator = vtk::TakeSmartPointer(source.Input->NewIterator());
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
  {
    vtkDataObject* leaf = iterator->GetCurrentDataObject();
    if (!IsOfRequiredType(leaf, port))
    {
      continue;
    }
    const unsigned int index = iterator->GetCurrentFlatIndex();
    indices.insert(index);
    vtkSmartPointer<vtkBlockAttributesPolyDataMapper>& mapper = this->Mappers[index];
    const bool isNew = !mapper;
    if (isNew)
    {
      mapper.TakeReference(parent->NewInstance());
      mapper->SetPopulateSelectionSettings(0);
      this->Forward(mapper, vtkCommand::ErrorEvent);
      this->Forward(mapper, vtkCommand::WarningEvent);
    }
    if (changed || isNew)
    {
      mapper->ShallowCopy(parent);
      // The parent has requested the piece; its blocks are drawn completely.
      mapper->SetNumberOfPieces(1);
      mapper->SetNumberOfSubPieces(1);
      mapper->SetGhostLevel(0);
      mapper->SetCompositeDataDisplayAttributes(nullptr);
    }
    if (mapper->GetInputDataObject(0, 0) != leaf)
    {
      mapper->SetInputDataObject(leaf);
    }
  }
  for (auto block = this->Mappers.begin(); block != this->Mappers.end();)
  {
    if (indices.count(block->first))
    {
      ++block;
      continue;
    }
    this->OnRemove(block->second);
    block = this->Mappers.erase(block);
  }
  this->UpdateAttributes(source);
  this->ParentTime = source.GetBuildTime(); // copying may have created its lookup table
}

void RefinementBlocks::Clear()
{
  for (const auto& block : this->Mappers)
  {
    this->OnRemove(block.second);
  }
  this->Mappers.clear();
}

void RefinementBlocks::Forward(vtkBlockAttributesPolyDataMapper* block, unsigned long event)
{
  vtkNew<vtkCallbackCommand> command;
  command->SetCallback(
    [](vtkObject*, unsigned long id, void* client, void* data)
    {
      RefinementBlocks* self = static_cast<RefinementBlocks*>(client);
      const char* text = static_cast<const char*>(data);
      if (!self->Messages.insert(GetMessage(text)).second)
      {
        return;
      }
      // Like VTK's macros, this calls the observers, or prints to the output window if there are
      // none.
      if (self->Parent->HasObserver(id))
      {
        self->Parent->InvokeEvent(id, data);
      }
      else if (id == vtkCommand::ErrorEvent)
      {
        vtkOutputWindowDisplayErrorText(text);
      }
      else
      {
        vtkOutputWindowDisplayWarningText(text);
      }
    });
  command->SetClientData(this);
  block->AddObserver(event, command);
}

void RefinementBlocks::UpdateAttributes(const Source& source)
{
  const AttributesOfBlocks all =
    GetAttributesOfBlocks(source.Parent->GetCompositeDataDisplayAttributes(), source.Input);
  for (auto& block : this->Mappers)
  {
    source.SetAttributes(block.second, FindAttributes(all, block.first));
  }
}

void RefinementBlocks::Render(vtkRenderer* ren, vtkActor* act, bool drawsAll)
{
  this->Rendering = true;
  {
    LeafSelection selection(ren);
    // If an actor is drawn in both passes, each pass draws its blocks.
    const bool drawnTwice = !drawsAll && !ren->GetSelector() && act->HasOpaqueGeometry() &&
      act->HasTranslucentPolygonalGeometry();
    const bool translucent = act->IsRenderingTranslucentPolygonalGeometry() != 0;
    for (auto& block : this->Mappers)
    {
      if (!drawnTwice || block.second->HasTranslucentPolygonalGeometry() == translucent)
      {
        selection.Begin(block.first);
        block.second->RenderPiece(ren, act);
      }
    }
  }
  this->Rendering = false;
}

void RefinementBlocks::ProcessSelectorPixelBuffers(
  vtkHardwareSelector* selector, const std::vector<unsigned int>& pixels, vtkProp* prop)
{
  const unsigned char* indices =
    selector->GetRawPixelBuffer(vtkHardwareSelector::COMPOSITE_INDEX_PASS);
  if (!indices)
  {
    return;
  }
  std::map<unsigned int, std::vector<unsigned int>> pixelsOfBlock;
  for (unsigned int pixel : pixels)
  {
    const unsigned int index = indices[pixel] | indices[pixel + 1] << 8 | indices[pixel + 2] << 16;
    pixelsOfBlock[index].push_back(pixel);
  }
  for (auto& block : this->Mappers)
  {
    auto found = pixelsOfBlock.find(block.first);
    if (found != pixelsOfBlock.end())
    {
      block.second->SetPopulateSelectionSettings(1);
      block.second->ProcessSelectorPixelBuffers(selector, found->second, prop);
      block.second->SetPopulateSelectionSettings(0);
    }
  }
}

vtkBlockAttributesPolyDataMapper* RefinementBlocks::Find(unsigned int flatIndex) const
{
  const auto found = this->Mappers.find(flatIndex);
  return found == this->Mappers.end() ? nullptr : found->second.Get();
}

std::vector<unsigned int> RefinementBlocks::GetFlatIndices() const
{
  std::vector<unsigned int> indices;
  for (const auto& mapper : this->Mappers)
  {
    indices.push_back(mapper.first);
  }
  return indices;
}

void RefinementBlocks::ForEach(
  const std::function<void(vtkBlockAttributesPolyDataMapper*)>& work) const
{
  for (const auto& block : this->Mappers)
  {
    work(block.second);
  }
}
}
