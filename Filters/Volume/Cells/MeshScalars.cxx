// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/MeshScalars.h"

#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDataSet.h"
#include "vtkInformation.h"
#include "vtkInformationStringKey.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <sstream>

namespace relevo
{
namespace
{
struct FoundSet
{
  vtkDataSet* Set;
  std::string Block;
};

std::string GetBlock(vtkCompositeDataIterator* leaf)
{
  const std::string block = "Block " + std::to_string(leaf->GetCurrentFlatIndex());
  const char* name = leaf->HasCurrentMetaData()
    ? leaf->GetCurrentMetaData()->Get(vtkCompositeDataSet::NAME())
    : nullptr;
  return name ? block + " (\"" + name + "\"): " : block + ": ";
}

std::vector<FoundSet> FindDataSets(vtkDataObject* input)
{
  std::vector<FoundSet> sets;
  const auto add = [&sets](vtkDataObject* object, const std::string& block)
  {
    vtkDataSet* set = vtkDataSet::SafeDownCast(object);
    if (set && set->GetNumberOfCells() > 0)
    {
      sets.push_back({ set, block });
    }
  };
  add(input, std::string());
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(input))
  {
    vtkSmartPointer<vtkCompositeDataIterator> leaf;
    leaf.TakeReference(composite->NewIterator());
    for (leaf->InitTraversal(); !leaf->IsDoneWithTraversal(); leaf->GoToNextItem())
    {
      add(leaf->GetCurrentDataObject(), GetBlock(leaf));
    }
  }
  return sets;
}

std::string FindFault(
  const MeshScalars& scalars, const ArrayWish& wish, const std::string& name, int components)
{
  std::ostringstream text;
  if (!scalars.Array)
  {
    text << "has no " << (name.empty() ? "active scalars" : "array \"" + name + "\"")
         << (components > 0 ? " in one of its blocks" : "") << "; choose an array by "
         << wish.Setter;
    return text.str();
  }
  const vtkIdType tuples = scalars.Array->GetNumberOfTuples();
  const vtkIdType wanted =
    scalars.AreOfCells ? scalars.Mesh->GetNumberOfCells() : scalars.Mesh->GetNumberOfPoints();
  const int given = scalars.Array->GetNumberOfComponents();
  const std::string named = "has an array \"" + name + "\" with ";
  if (tuples != wanted)
  {
    text << named << tuples << " tuples for " << wanted
         << (scalars.AreOfCells ? " cells" : " points");
  }
  else if (given > wish.MostComponents)
  {
    text << named << given << " components; there can be 1 to " << wish.MostComponents;
  }
  else if (components > 0 && given != components)
  {
    text << named << components << " components in one block and " << given << " in another";
  }
  return text.str();
}
}

vtkMTimeType GetMeshTime(vtkDataObject* input)
{
  vtkMTimeType time = input->GetMTime();
  for (const FoundSet& found : FindDataSets(input))
  {
    time = std::max(time, found.Set->GetMTime());
  }
  return time;
}

bool FindMeshScalars(
  vtkDataObject* input, const ArrayWish& wish, std::vector<MeshScalars>& found, std::string& error)
{
  found.clear();
  for (const auto& [set, block] : FindDataSets(input))
  {
    int association = vtkDataObject::FIELD_ASSOCIATION_POINTS;
    vtkDataArray* array = wish.Find(set, association);
    found.push_back({ set, array, association == vtkDataObject::FIELD_ASSOCIATION_CELLS, block });
    const char* own = array ? array->GetName() : nullptr;
    error = FindFault(found.back(), wish, wish.Name.empty() && own ? own : wish.Name,
      found.size() > 1 ? found.front().Array->GetNumberOfComponents() : 0);
    if (!error.empty())
    {
      return false;
    }
  }
  return true;
}
}
