// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/MeshScalars.h"

#include "Checks/LeftOutBlocks.h"
#include "Compatibility/VTKCompatibility.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDataSet.h"
#include "vtkGenericCell.h"
#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <sstream>

namespace relevo
{
namespace
{
struct Block
{
  vtkDataSet* Set;
  std::string Name; // empty for an input that is not composite
};

// Returns the data sets that have cells.
std::vector<Block> FindBlocks(vtkDataObject* input)
{
  std::vector<Block> blocks;
  const auto add = [&blocks](vtkDataObject* object, const std::string& name)
  {
    vtkDataSet* set = vtkDataSet::SafeDownCast(object);
    if (set && set->GetNumberOfCells() > 0)
    {
      blocks.push_back({ set, name });
    }
  };
  add(input, "");
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(input))
  {
    vtkSmartPointer<vtkCompositeDataIterator> leaf;
    leaf.TakeReference(composite->NewIterator());
    for (leaf->InitTraversal(); !leaf->IsDoneWithTraversal(); leaf->GoToNextItem())
    {
      add(leaf->GetCurrentDataObject(), GetBlockName(leaf));
    }
  }
  return blocks;
}

// Cells of unknown types, and grids with an incomplete list of types, count as 3D, so that
// CheckCells() reports them.
bool HasSolidCells(vtkDataSet* mesh)
{
  auto* grid = vtkUnstructuredGrid::SafeDownCast(mesh);
  if (grid && GetNumberOfCellTypes(grid) < grid->GetNumberOfCells())
  {
    return true;
  }
  int known = -1; // the last type that is not 3D
  for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
  {
    const int type = mesh->GetCellType(i);
    if (type != known)
    {
      const auto cell = vtkSmartPointer<vtkCell>::Take(vtkGenericCell::InstantiateCell(type));
      if (!cell || cell->GetCellDimension() == 3)
      {
        return true;
      }
      known = type;
    }
  }
  return false;
}

// Returns "active scalars", or "point array "NAME"".
std::string NameArray(const std::string& name, const char* kind)
{
  return name.empty() ? "active scalars" : std::string(kind) + "array \"" + name + "\"";
}

// Returns why a block is skipped while others are not, or "".
std::string FindLack(
  const MeshScalars& scalars, const ArrayRequest& request, const MeshScalars* first)
{
  if (!HasSolidCells(scalars.Mesh))
  {
    return "has no 3D cells";
  }
  // There is no advice to choose the other association: the blocks differ, so that others would be
  // lost.
  const auto lackOf = [&](int association, const char* kind)
  {
    const std::string misplaced = DescribeMisplacedArray(
      scalars.Mesh, request.Name, association, [](int) { return std::string(); });
    return "has " + (misplaced.empty() ? "no " + NameArray(request.Name, kind) : misplaced);
  };
  if (!scalars.Array)
  {
    return lackOf(request.Association, "");
  }
  if (first && first->AreOfCells != scalars.AreOfCells)
  {
    return first->AreOfCells ? lackOf(vtkDataObject::FIELD_ASSOCIATION_CELLS, "cell ")
                             : lackOf(vtkDataObject::FIELD_ASSOCIATION_POINTS, "point ");
  }
  return "";
}

std::string FindError(const MeshScalars& scalars, const ArrayRequest& request,
  const std::string& name, const MeshScalars& first)
{
  std::ostringstream text;
  const vtkIdType tuples = scalars.Array->GetNumberOfTuples();
  const vtkIdType wanted =
    scalars.AreOfCells ? scalars.Mesh->GetNumberOfCells() : scalars.Mesh->GetNumberOfPoints();
  const int given = scalars.Array->GetNumberOfComponents();
  const int others = first.Array->GetNumberOfComponents();
  const auto inBlock = [](const MeshScalars& block)
  { return block.Block.empty() ? "" : " in " + block.Block; };
  const std::string named = "has an array \"" + name + "\"" + inBlock(scalars) + " with ";
  if (tuples != wanted)
  {
    text << named << tuples << " tuples, but there are " << wanted
         << (scalars.AreOfCells ? " cells" : " points");
  }
  else if (given > request.MaximumComponents)
  {
    text << named << given << " components, but the limit is " << request.MaximumComponents;
  }
  else if (given != others)
  {
    text << named << given << " components, but with " << others << inBlock(first);
  }
  return text.str();
}
}

vtkMTimeType GetMeshTime(vtkDataObject* input)
{
  vtkMTimeType time = input->GetMTime();
  for (const Block& block : FindBlocks(input))
  {
    time = std::max(time, block.Set->GetMTime());
  }
  return time;
}

bool FindMeshScalars(vtkDataObject* input, const ArrayRequest& request,
  std::vector<MeshScalars>& found, std::string& error, std::string& warning)
{
  found.clear();
  LeftOutBlocks leftOut;
  bool hasSolidCells = false;
  std::string misplaced;
  const std::vector<Block> blocks = FindBlocks(input);
  for (const Block& block : blocks)
  {
    int association = vtkDataObject::FIELD_ASSOCIATION_POINTS;
    vtkDataArray* array = request.Find(block.Set, association);
    const MeshScalars scalars = { block.Set, array,
      association == vtkDataObject::FIELD_ASSOCIATION_CELLS, block.Name };
    const std::string lack = FindLack(scalars, request, found.empty() ? nullptr : &found.front());
    if (!lack.empty())
    {
      hasSolidCells = hasSolidCells || HasSolidCells(block.Set);
      misplaced = misplaced.empty()
        ? DescribeMisplacedArray(block.Set, request.Name, request.Association, request.Advise)
        : misplaced;
      leftOut.Add(block.Name, lack);
      continue;
    }
    found.push_back(scalars);
    const char* own = array->GetName();
    error = FindError(
      found.back(), request, request.Name.empty() && own ? own : request.Name, found.front());
    if (!error.empty())
    {
      return false;
    }
  }
  if (found.empty() && !blocks.empty())
  {
    error = !hasSolidCells ? "has no 3D cells"
      : !misplaced.empty()
      ? "has " + misplaced
      : "has no " + NameArray(request.Name, "") + "; select an array with " + request.Setter;
    return false;
  }
  warning = leftOut.GetText();
  return true;
}
}
