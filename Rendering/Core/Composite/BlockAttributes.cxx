// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Composite/BlockAttributes.h"

#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeRange.h"

namespace relevo
{
namespace
{
// Call enter(object, index, context) for every node in depth-first order. The context is the result
// of the call for the parent node.
template <typename Context, typename Enter>
void Visit(vtkDataObject* object, unsigned int& nextIndex, Context context, const Enter& enter)
{
  enter(object, nextIndex++, context);
  if (vtkDataObjectTree* tree = vtkDataObjectTree::SafeDownCast(object))
  {
    for (vtkDataObject* child : vtk::Range(tree, vtk::DataObjectTreeOptions::None))
    {
      Visit(child, nextIndex, context, enter);
    }
  }
}

void ApplyOwn(
  vtkCompositeDataDisplayAttributes* attributes, vtkDataObject* block, BlockAttributes& own)
{
  if (attributes->HasBlockVisibility(block))
  {
    own.Visible = attributes->GetBlockVisibility(block);
  }
  if (attributes->HasBlockPickability(block))
  {
    own.Pickable = attributes->GetBlockPickability(block);
  }
  if (attributes->HasBlockOpacity(block))
  {
    own.HasOpacity = true;
    own.Opacity = attributes->GetBlockOpacity(block);
  }
  if (attributes->HasBlockColor(block))
  {
    own.HasColor = true;
    attributes->GetBlockColor(block, own.Color);
  }
}
}

AttributesOfBlocks GetAttributesOfBlocks(
  vtkCompositeDataDisplayAttributes* attributes, vtkDataObject* input)
{
  AttributesOfBlocks blocks;
  if (!attributes)
  {
    return blocks;
  }
  unsigned int nextIndex = 0;
  Visit(input, nextIndex, BlockAttributes(),
    [&](vtkDataObject* block, unsigned int index, BlockAttributes& own)
    {
      if (block)
      {
        ApplyOwn(attributes, block, own);
        if (!vtkDataObjectTree::SafeDownCast(block))
        {
          blocks[index] = own;
        }
      }
    });
  return blocks;
}

bool FindBlock(vtkDataObject* input, unsigned int flatIndex, vtkDataObject*& block)
{
  bool found = false;
  unsigned int nextIndex = 0;
  Visit(input, nextIndex, 0,
    [&](vtkDataObject* object, unsigned int index, int)
    {
      if (index == flatIndex)
      {
        found = true;
        block = object;
      }
    });
  return found;
}
}
