// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "CurveTree.h"

#include "Composite/BlockAttributes.h"
#include "Composite/DataLeaves.h"
#include "CurveLines.h"
#include "vtkCompositeDataSet.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <map>
#include <vector>

namespace relevo
{
vtkDataObject* CurveTree::Make(vtkDataObject* lines, vtkCompositeDataDisplayAttributes* attributes)
{
  auto tree = vtkCompositeDataSet::SafeDownCast(lines);
  const AttributesOfBlocks blocks = GetAttributesOfBlocks(attributes, tree);
  std::vector<DataLeaf> visible;
  Dependencies sources;
  sources.AddObject(tree);
  for (const DataLeaf& leaf : FindDataLeaves(tree))
  {
    const bool isVisible = FindAttributes(blocks, leaf.FlatIndex).Visible;
    sources.Add(isVisible);
    sources.AddObject(leaf.Data);
    if (isVisible)
    {
      visible.push_back(leaf);
    }
  }
  if (!this->Sources.Update(sources))
  {
    return this->Curves;
  }
  std::map<unsigned int, vtkSmartPointer<vtkUnstructuredGrid>> curves; // by flat index
  for (const DataLeaf& leaf : visible)
  {
    auto mesh = vtkPolyData::SafeDownCast(leaf.Data);
    if (mesh && mesh->GetNumberOfLines() > 0)
    {
      curves[leaf.FlatIndex] = MakeCurveGrid(mesh);
    }
  }
  this->Lines = lines;
  this->Curves = nullptr;
  if (tree)
  {
    this->Curves = ReplaceLeaves(tree,
      [&curves](unsigned int index)
      { return curves.count(index) ? curves[index].Get() : nullptr; });
  }
  return this->Curves;
}
}
