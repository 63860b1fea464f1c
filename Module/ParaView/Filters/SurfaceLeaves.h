// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   the surfaces of a tree of data sets, and their pieces
 *
 * For the sources of the plugin.
 */
#ifndef SurfaceLeaves_h
#define SurfaceLeaves_h

#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkMultiPieceDataSet.h"
#include "vtkPartitionedDataSet.h"
#include "vtkSmartPointer.h"

namespace relevo
{
/**
 * Call f(tree, iterator at one of its leaves) for all leaves, and start() before each surface.
 * Partitions are pieces of one surface; any other leaf is a separate surface. nullptr has no
 * leaves.
 */
template <typename Start, typename Function>
void ForEachLeaf(vtkDataObjectTree* tree, Start&& start, Function&& f)
{
  if (!tree)
  {
    return;
  }
  const bool hasPieces =
    vtkPartitionedDataSet::SafeDownCast(tree) || vtkMultiPieceDataSet::SafeDownCast(tree);
  if (hasPieces)
  {
    start();
  }
  auto iterator = vtk::TakeSmartPointer(tree->NewTreeIterator());
  iterator->SkipEmptyNodesOff();
  iterator->VisitOnlyLeavesOff();
  iterator->TraverseSubTreeOff();
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
  {
    if (auto subTree = vtkDataObjectTree::SafeDownCast(iterator->GetCurrentDataObject()))
    {
      ForEachLeaf(subTree, start, f);
      continue;
    }
    if (!hasPieces)
    {
      start();
    }
    f(tree, iterator.Get());
  }
}

template <typename Function>
void ForEachLeaf(vtkDataObjectTree* tree, Function&& f)
{
  ForEachLeaf(
    tree, [] {}, f);
}
}

#endif
