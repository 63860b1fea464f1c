// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RegionFaces.h"

#include "Actors/UsableArrays.h"
#include "Arrays/GhostCells.h"
#include "CellSubset.h"
#include "FaceOrder.h"
#include "Mesh/FaceBounds.h"
#include "Mesh/RefinementMesh.h"
#include "PatchTree.h"
#include "SurfaceLeaves.h"
#include "SurfacePieces.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkCellData.h"
#include "vtkMatrix4x4.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkPatchSurface.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string>
#include <utility>

namespace relevo
{
namespace
{
constexpr double Nothing = -VTK_DOUBLE_MAX; // upper side of a box without points

// A leaf, and the bounds of its coarse and refined cells in world coordinates. Ghosts have empty
// bounds.
struct Leaf
{
  vtkSmartPointer<vtkPolyData> Mesh;
  std::vector<vtkBoundingBox> Coarse;
  std::vector<vtkBoundingBox> Refined;
};
using Surface = std::vector<Leaf>;

void AddTransformed(const double bounds[6], vtkMatrix4x4* matrix, vtkBoundingBox& box)
{
  double low[3];
  double high[3];
  for (int row = 0; row < 3; ++row)
  {
    low[row] = high[row] = matrix->GetElement(row, 3);
    for (int column = 0; column < 3; ++column)
    {
      const double a = matrix->GetElement(row, column) * bounds[2 * column];
      const double b = matrix->GetElement(row, column) * bounds[2 * column + 1];
      low[row] += std::min(a, b);
      high[row] += std::max(a, b);
    }
  }
  box.AddPoint(low);
  box.AddPoint(high);
}

// Add the boxes of refined faces, by cell.
void AddRefinedBoxes(vtkAdaptiveRefinement* recipe, vtkMatrix4x4* matrix, vtkPolyData* faces,
  std::vector<vtkBoundingBox>& boxes)
{
  RefinementMesh mesh;
  // A mesh that cannot be refined is not drawn; its mapper reports why.
  if (!mesh.Build(faces, recipe->GetSurface(), recipe->GetDisplacement()))
  {
    return;
  }
  const FaceBounds reach(mesh, recipe->GetSurface(), recipe->GetDisplacement());
  for (std::size_t face = 0; face < mesh.Faces.size(); ++face)
  {
    double low[3];
    double high[3];
    double bounds[6];
    reach.GetBox(face, low, high);
    for (int c = 0; c < 3; ++c)
    {
      bounds[2 * c] = mesh.Origin[c] + low[c];
      bounds[2 * c + 1] = mesh.Origin[c] + high[c];
    }
    AddTransformed(bounds, matrix, boxes[static_cast<std::size_t>(mesh.Faces[face].Cell)]);
  }
}

void ComputeBoxes(vtkAdaptiveRefinement* recipe, vtkMatrix4x4* matrix, Leaf& leaf)
{
  const auto numberOfCells = static_cast<std::size_t>(leaf.Mesh->GetNumberOfCells());
  const GhostCells ghosts(leaf.Mesh);
  leaf.Coarse.resize(numberOfCells);
  double bounds[6];
  for (std::size_t cell = 0; cell < numberOfCells; ++cell)
  {
    const auto id = static_cast<vtkIdType>(cell);
    if (!ghosts.Has(id) && leaf.Mesh->GetCellSize(id) > 0)
    {
      leaf.Mesh->GetCellBounds(id, bounds);
      AddTransformed(bounds, matrix, leaf.Coarse[cell]);
    }
  }
  leaf.Refined = leaf.Coarse;
  if (recipe && vtkPatchSurface::SafeDownCast(recipe->GetSurface()))
  {
    std::vector<vtkIdType> cells;
    const vtkSmartPointer<vtkPolyData> patches = MakePatches(leaf.Mesh, cells);
    std::vector<vtkBoundingBox> boxes(cells.size());
    AddRefinedBoxes(recipe, matrix, patches, boxes);
    for (std::size_t i = 0; i < cells.size(); ++i)
    {
      const auto cell = static_cast<std::size_t>(cells[i]);
      if (leaf.Coarse[cell].IsValid())
      {
        leaf.Refined[cell].AddBox(boxes[i]);
      }
    }
  }
  else if (recipe)
  {
    AddRefinedBoxes(recipe, matrix, leaf.Mesh, leaf.Refined);
  }
}

// Return a mesh that can be cut; nullptr if cells lack points.
vtkSmartPointer<vtkPolyData> FindUsable(vtkPolyData* mesh)
{
  if (IsSound(mesh))
  {
    return mesh;
  }
  auto usable = vtkSmartPointer<vtkPolyData>::New();
  usable->ShallowCopy(mesh);
  const std::string warning = RemoveUnusableArrays(usable);
  if (!warning.empty())
  {
    vtkWarningWithObjectMacro(mesh, << warning);
  }
  if (!IsSound(usable))
  {
    vtkErrorWithObjectMacro(mesh, "Cells refer to points that do not exist. Nothing is drawn.");
    return nullptr;
  }
  return usable;
}

std::vector<Surface> FindSurfaces(
  vtkDataObjectTree* tree, vtkAdaptiveRefinement* recipe, vtkMatrix4x4* matrix)
{
  std::vector<Surface> surfaces;
  const auto start = [&] { surfaces.emplace_back(); };
  const auto add = [&](vtkDataObjectTree*, vtkDataObjectTreeIterator* iterator)
  {
    Leaf leaf;
    if (auto mesh = vtkPolyData::SafeDownCast(iterator->GetCurrentDataObject()))
    {
      leaf.Mesh = FindUsable(mesh);
    }
    if (leaf.Mesh)
    {
      ComputeBoxes(recipe, matrix, leaf);
    }
    surfaces.back().push_back(std::move(leaf));
  };
  if (tree)
  {
    ForEachLeaf(tree, start, add);
  }
  return surfaces;
}

// Compute bounds of the coarse cells of all processes that are drawn in each region. All their
// neighbours touch these bounds.
std::vector<vtkBoundingBox> ComputeHulls(const std::vector<Surface>& surfaces,
  const std::vector<vtkBoundingBox>& regions, vtkMultiProcessController* controller)
{
  std::vector<double> own(6 * regions.size(), Nothing); // negated lower sides, and upper sides
  for (std::size_t region = 0; region < regions.size(); ++region)
  {
    vtkBoundingBox hull;
    for (const Surface& surface : surfaces)
    {
      for (const Leaf& leaf : surface)
      {
        for (std::size_t cell = 0; cell < leaf.Refined.size(); ++cell)
        {
          if (leaf.Refined[cell].Intersects(regions[region]))
          {
            hull.AddBox(leaf.Coarse[cell]);
          }
        }
      }
    }
    for (int side = 0; side < 6 && hull.IsValid(); ++side)
    {
      own[6 * region + side] = (side % 2 == 0 ? -1.0 : 1.0) * hull.GetBound(side);
    }
  }
  std::vector<double> all(own.size());
  controller->AllReduce(
    own.data(), all.data(), static_cast<vtkIdType>(own.size()), vtkCommunicator::MAX_OP);
  std::vector<vtkBoundingBox> hulls(regions.size());
  for (std::size_t region = 0; region < regions.size(); ++region)
  {
    const double* sides = &all[6 * region];
    if (sides[0] != Nothing)
    {
      hulls[region].SetBounds(-sides[0], sides[1], -sides[2], sides[3], -sides[4], sides[5]);
    }
  }
  return hulls;
}

// Return the cells that a region needs.
vtkSmartPointer<vtkPolyData> ExtractNeeded(
  const Leaf& leaf, const vtkBoundingBox& region, const vtkBoundingBox& hull)
{
  const std::size_t numberOfCells = leaf.Refined.size();
  auto given = vtkUnsignedCharArray::SafeDownCast(
    leaf.Mesh->GetCellData()->GetArray(vtkDataSetAttributes::GhostArrayName()));
  std::vector<unsigned char> types(numberOfCells);
  std::vector<bool> needed(numberOfCells);
  for (std::size_t cell = 0; cell < numberOfCells; ++cell)
  {
    const bool isDrawn = leaf.Refined[cell].Intersects(region);
    needed[cell] = isDrawn || leaf.Coarse[cell].Intersects(hull);
    types[cell] = given ? given->GetValue(static_cast<vtkIdType>(cell)) : 0;
    types[cell] |= isDrawn ? 0 : vtkDataSetAttributes::DUPLICATECELL;
  }
  vtkNew<vtkPolyData> mesh;
  mesh->ShallowCopy(leaf.Mesh);
  SetGhostTypes(mesh, types);
  return ExtractCells(mesh, needed);
}

// Return the cells of this process's surfaces that a region needs, one block per surface.
vtkSmartPointer<vtkMultiBlockDataSet> MakeMessage(
  const std::vector<Surface>& surfaces, const vtkBoundingBox& region, const vtkBoundingBox& hull)
{
  auto message = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  message->SetNumberOfBlocks(static_cast<unsigned int>(surfaces.size()));
  for (std::size_t i = 0; i < surfaces.size(); ++i)
  {
    std::vector<vtkSmartPointer<vtkPolyData>> pieces;
    for (const Leaf& leaf : surfaces[i])
    {
      vtkSmartPointer<vtkPolyData> piece = leaf.Mesh ? ExtractNeeded(leaf, region, hull) : nullptr;
      if (piece && piece->GetNumberOfCells() > 0)
      {
        pieces.push_back(piece);
      }
    }
    message->SetBlock(static_cast<unsigned int>(i), AppendMeshes(pieces));
  }
  return message;
}

// Merge the surfaces of all processes' messages, in the order of the processes.
std::vector<vtkSmartPointer<vtkPolyData>> Unite(
  const std::vector<vtkSmartPointer<vtkDataObject>>& messages)
{
  std::vector<std::vector<vtkSmartPointer<vtkPolyData>>> pieces;
  for (vtkDataObject* message : messages)
  {
    auto blocks = vtkMultiBlockDataSet::SafeDownCast(message);
    for (unsigned int i = 0; blocks && i < blocks->GetNumberOfBlocks(); ++i)
    {
      pieces.resize(std::max<std::size_t>(pieces.size(), i + 1));
      if (auto piece = vtkPolyData::SafeDownCast(blocks->GetBlock(i)))
      {
        pieces[i].push_back(piece);
      }
    }
  }
  std::vector<vtkSmartPointer<vtkPolyData>> surfaces;
  std::transform(pieces.begin(), pieces.end(), std::back_inserter(surfaces), AppendMeshes);
  for (vtkPolyData* surface : surfaces)
  {
    if (surface)
    {
      SortByPosition(surface);
    }
  }
  return surfaces;
}

// Add an empty piece to surfaces that have none on this process.
void AddFirstPieces(vtkDataObjectTree* tree)
{
  if (auto pieces = vtkMultiPieceDataSet::SafeDownCast(tree))
  {
    pieces->SetNumberOfPieces(std::max(1u, pieces->GetNumberOfPieces()));
    return;
  }
  if (auto partitions = vtkPartitionedDataSet::SafeDownCast(tree))
  {
    partitions->SetNumberOfPartitions(std::max(1u, partitions->GetNumberOfPartitions()));
    return;
  }
  auto iterator = vtk::TakeSmartPointer(tree->NewTreeIterator());
  iterator->VisitOnlyLeavesOff();
  iterator->TraverseSubTreeOff();
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
  {
    if (auto subTree = vtkDataObjectTree::SafeDownCast(iterator->GetCurrentDataObject()))
    {
      AddFirstPieces(subTree);
    }
  }
}

// Return a tree of the same structure with these surfaces.
vtkSmartPointer<vtkDataObjectTree> MakeTree(
  vtkDataObjectTree* like, const std::vector<vtkSmartPointer<vtkPolyData>>& surfaces)
{
  vtkSmartPointer<vtkDataObjectTree> tree;
  if (like)
  {
    tree.TakeReference(like->NewInstance());
    tree->ShallowCopy(like);
  }
  else
  {
    tree = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  }
  AddFirstPieces(tree);
  std::size_t surface = 0;
  bool isFirst = true;
  ForEachLeaf(
    tree,
    [&]
    {
      ++surface;
      isFirst = true;
    },
    [&](vtkDataObjectTree* parent, vtkDataObjectTreeIterator* leaf)
    {
      const bool has = isFirst && surface <= surfaces.size() && surfaces[surface - 1];
      parent->SetDataSet(leaf, has ? surfaces[surface - 1] : vtkSmartPointer<vtkPolyData>());
      isFirst = false;
    });
  // Add blocks that are missing on this process.
  auto blocks = vtkMultiBlockDataSet::SafeDownCast(tree);
  for (; blocks && surface < surfaces.size(); ++surface)
  {
    blocks->SetBlock(blocks->GetNumberOfBlocks(), surfaces[surface]);
  }
  return tree;
}
}

vtkSmartPointer<vtkDataObjectTree> GatherRegionFaces(vtkDataObjectTree* tree,
  vtkAdaptiveRefinement* recipe, vtkMatrix4x4* matrix, const std::vector<vtkBoundingBox>& regions,
  vtkMultiProcessController* controller)
{
  const std::vector<Surface> own = FindSurfaces(tree, recipe, matrix);
  const std::vector<vtkBoundingBox> hulls = ComputeHulls(own, regions, controller);
  std::vector<vtkSmartPointer<vtkDataObject>> messages;
  bool succeeded = true;
  for (std::size_t region = 0; region < regions.size(); ++region)
  {
    succeeded = controller->Gather(MakeMessage(own, regions[region], hulls[region]), messages,
                  static_cast<int>(region)) &&
      succeeded;
  }
  return succeeded ? MakeTree(tree, Unite(messages)) : nullptr;
}
}
