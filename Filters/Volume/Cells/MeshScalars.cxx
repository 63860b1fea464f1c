// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/MeshScalars.h"

#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDataSet.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <sstream>

namespace relevo
{
namespace
{
std::vector<vtkDataSet*> FindDataSets(vtkDataObject* input)
{
  std::vector<vtkDataSet*> sets;
  const auto add = [&sets](vtkDataObject* object)
  {
    vtkDataSet* set = vtkDataSet::SafeDownCast(object);
    if (set && set->GetNumberOfCells() > 0)
    {
      sets.push_back(set);
    }
  };
  add(input);
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(input))
  {
    vtkSmartPointer<vtkCompositeDataIterator> leaf;
    leaf.TakeReference(composite->NewIterator());
    for (leaf->InitTraversal(); !leaf->IsDoneWithTraversal(); leaf->GoToNextItem())
    {
      add(leaf->GetCurrentDataObject());
    }
  }
  return sets;
}

// Cells that refer to points that do not exist; for polyhedra, faces count as well.
vtkIdType CountBrokenCells(vtkDataSet* mesh)
{
  auto* grid = vtkUnstructuredGrid::SafeDownCast(mesh);
  const vtkIdType points = mesh->GetNumberOfPoints();
  vtkNew<vtkIdList> ids;
  vtkIdType broken = 0;
  const auto exists = [=](vtkIdType id) { return id >= 0 && id < points; };
  for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
  {
    mesh->GetCellPoints(i, ids);
    bool isGood = std::all_of(ids->begin(), ids->end(), exists);
    if (grid && grid->GetCellType(i) == VTK_POLYHEDRON)
    {
      grid->GetFaceStream(i, ids);
      // The number of faces, then of each the number of its points and these.
      vtkIdType at = 1;
      while (at < ids->GetNumberOfIds())
      {
        const vtkIdType last = std::min(at + ids->GetId(at), ids->GetNumberOfIds() - 1);
        isGood = isGood && std::all_of(ids->begin() + at + 1, ids->begin() + last + 1, exists);
        at = last + 1;
      }
    }
    broken += isGood ? 0 : 1;
  }
  return broken;
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
  if (const vtkIdType broken = CountBrokenCells(scalars.Mesh))
  {
    text << "has cells that refer to points that do not exist: " << broken << " of "
         << scalars.Mesh->GetNumberOfCells();
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
  for (vtkDataSet* set : FindDataSets(input))
  {
    time = std::max(time, set->GetMTime());
  }
  return time;
}

bool FindMeshScalars(
  vtkDataObject* input, const ArrayWish& wish, std::vector<MeshScalars>& found, std::string& error)
{
  found.clear();
  for (vtkDataSet* set : FindDataSets(input))
  {
    int association = vtkDataObject::FIELD_ASSOCIATION_POINTS;
    vtkDataArray* array = wish.Find(set, association);
    found.push_back({ set, array, association == vtkDataObject::FIELD_ASSOCIATION_CELLS });
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
