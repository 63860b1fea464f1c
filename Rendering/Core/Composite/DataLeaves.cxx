// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Composite/DataLeaves.h"

#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"

namespace relevo
{
std::vector<DataLeaf> FindDataLeaves(vtkDataObject* input)
{
  std::vector<DataLeaf> leaves;
  auto* composite = vtkCompositeDataSet::SafeDownCast(input);
  if (!composite)
  {
    if (input)
    {
      leaves.push_back({ 0, input });
    }
    return leaves;
  }
  auto leaf = vtk::TakeSmartPointer(composite->NewIterator());
  for (leaf->InitTraversal(); !leaf->IsDoneWithTraversal(); leaf->GoToNextItem())
  {
    leaves.push_back({ leaf->GetCurrentFlatIndex(), leaf->GetCurrentDataObject() });
  }
  return leaves;
}

Dependencies GetLeafDependencies(vtkDataObject* input)
{
  Dependencies dependencies;
  dependencies.AddObject(input);
  if (vtkCompositeDataSet::SafeDownCast(input))
  {
    for (const DataLeaf& leaf : FindDataLeaves(input))
    {
      dependencies.AddObject(leaf.Data);
    }
  }
  return dependencies;
}

vtkSmartPointer<vtkCompositeDataSet> ReplaceLeaves(
  vtkCompositeDataSet* composite, const std::function<vtkDataObject*(unsigned int)>& replace)
{
  auto copy = vtk::TakeSmartPointer(composite->NewInstance());
  copy->CopyStructure(composite);
  auto leaf = vtk::TakeSmartPointer(composite->NewIterator());
  for (leaf->InitTraversal(); !leaf->IsDoneWithTraversal(); leaf->GoToNextItem())
  {
    copy->SetDataSet(leaf, replace(leaf->GetCurrentFlatIndex()));
  }
  return copy;
}
}
