// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Picking/PickedInput.h"

#include "State/RefinementState.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

namespace relevo
{
PickedInput::PickedInput() = default;
PickedInput::~PickedInput() = default;

vtkPolyData* PickedInput::Get(const Source& source, bool isAsked)
{
  const RefinementMesh& mesh = source.State->GetMesh();
  const vtkMTimeType meshTime = source.State->GetMeshTime();
  const PatternSelection* selection = this->Levels.Get(
    source.Input, source.Recipe, mesh, meshTime, source.State->GetSelection(), source.Kind);
  if (!selection)
  {
    return this->Empty;
  }
  this->Surface.Update(mesh, meshTime, source.Recipe, source.Input->GetPointData()->GetNormals());
  PickedSurface surface = { source.Input, &mesh, &this->Surface, selection, {} };
  source.State->GetBounds(source.Recipe, surface.Bounds);
  this->Data->Take(surface);
  if (isAsked)
  {
    this->Data->Ask();
  }
  return this->Data;
}

vtkDataObject* PickedInput::GetComposite(
  vtkCompositeDataSet* input, const std::function<vtkPolyData*(unsigned int)>& getLeaf)
{
  this->Composite.TakeReference(input->NewInstance());
  this->Composite->CopyStructure(input);
  auto iterator = vtk::TakeSmartPointer(input->NewIterator());
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
  {
    this->Composite->SetDataSet(iterator, getLeaf(iterator->GetCurrentFlatIndex()));
  }
  return this->Composite;
}
}
