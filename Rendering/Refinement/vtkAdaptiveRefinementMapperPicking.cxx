// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// What VTK's pickers find.
#include "Composite/BlockAttributes.h"
#include "vtkAdaptiveRefinementMapperInternals.h"

#include "vtkAdaptiveRefinement.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

void vtkAdaptiveRefinementMapper::vtkInternals::InitializePicking(
  vtkAdaptiveRefinementMapper* mapper)
{
  vtkNew<relevo::PickedInputPipeline> pipeline;
  pipeline->Replace = [mapper](vtkDataObject* input)
  { return mapper->ReplaceInput(mapper->ConvertInput(input)); };
  mapper->SetExecutive(pipeline);
}

vtkPolyData* vtkAdaptiveRefinementMapper::GetInput()
{
  this->Internals->Picking.Questions.AskOther();
  return this->Superclass::GetInput();
}

vtkDataSet* vtkAdaptiveRefinementMapper::GetInputAsDataSet()
{
  return this->GetInput();
}

vtkDataObject* vtkAdaptiveRefinementMapper::GetInputDataObject(int port, int connection)
{
  this->Internals->Picking.Questions.AskOther();
  return this->Superclass::GetInputDataObject(port, connection);
}

double* vtkAdaptiveRefinementMapper::GetBounds()
{
  const relevo::OwnBoundsQuestion question(this->Internals->Picking.Questions);
  return this->Superclass::GetBounds();
}

void vtkAdaptiveRefinementMapper::GetBounds(double bounds[6])
{
  this->Superclass::GetBounds(bounds);
  this->Internals->Picking.Questions.AskBounds();
}

vtkDataObject* vtkAdaptiveRefinementMapper::ReplaceInput(vtkDataObject* input)
{
  using Questions = relevo::PickerDetector;
  relevo::PickedInput& picking = this->Internals->Picking;
  vtkCompositeDataSet* composite = vtkCompositeDataSet::SafeDownCast(input);
  const Questions::Askers asker = picking.Questions.AskInput(composite != nullptr);
  if (asker == Questions::NO_PICKER)
  {
    return input;
  }
  const bool isAsked = asker == Questions::PICKER_OF_PARTS;
  const auto isPickable = [](vtkAdaptiveRefinementMapper* mapper)
  { return mapper->GetBlockAttributes().Visible && mapper->GetBlockAttributes().Pickable; };
  if (!composite)
  {
    vtkPolyData* picked = isPickable(this) ? this->GetPickedData(isAsked) : picking.Empty.Get();
    return picked ? picked : input;
  }
  picking.Composite.TakeReference(composite->NewInstance());
  picking.Composite->CopyStructure(composite);
  auto iterator = vtk::TakeSmartPointer(composite->NewIterator());
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
  {
    auto* block = static_cast<vtkAdaptiveRefinementMapper*>(
      this->Internals->Blocks.Find(iterator->GetCurrentFlatIndex()));
    if (block && !isPickable(block))
    {
      continue;
    }
    vtkPolyData* picked = block ? block->GetPickedData(isAsked) : nullptr;
    picking.Composite->SetDataSet(iterator, picked);
  }
  return picking.Composite;
}

vtkPolyData* vtkAdaptiveRefinementMapper::GetPickedData(bool isAsked)
{
  vtkInternals& data = *this->Internals;
  relevo::PickedInput& picking = data.Picking;
  vtkPolyData* input = this->GetInput();
  if (!input)
  {
    return nullptr;
  }
  if (!this->UpdateMesh() || input->GetNumberOfPoints() == 0)
  {
    return picking.Empty; // as there is nothing to be seen
  }
  this->ReadSelection();
  const relevo::RefinementMesh& mesh = data.State.GetMesh();
  const vtkMTimeType meshTime = data.State.GetMeshTime();
  using Levels = relevo::PickedLevels;
  const bool morphs = data.Methods.IsDefault() || data.Methods.GetNumber() == METHOD_ARK;
  const relevo::PatternSelection* selection =
    picking.Levels.Get(input, this->Refinement, mesh, meshTime, data.State.GetSelection(),
      morphs                                         ? Levels::MORPHED
        : data.Methods.GetNumber() == METHOD_UNIFORM ? Levels::HIGHEST
                                                     : Levels::ROUNDED);
  if (!selection)
  {
    return picking.Empty;
  }
  picking.Surface.Update(mesh, meshTime, this->Refinement, input->GetPointData()->GetNormals());
  relevo::PickedSurface surface = { input, &mesh, &picking.Surface, selection, {} };
  data.State.GetBounds(this->Refinement, surface.Bounds);
  picking.Data->Take(surface);
  if (isAsked)
  {
    picking.Data->Ask();
  }
  return picking.Data;
}
