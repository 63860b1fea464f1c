// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Blocks/BlockLook.h"

#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeRange.h"

namespace relevo
{
namespace
{
// Calls enter(object, index, context) for every node, depth first, with what the call for the node
// above has made of the context.
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

void ApplyOwn(vtkCompositeDataDisplayAttributes* attributes, vtkDataObject* block, BlockLook& look)
{
  if (attributes->HasBlockVisibility(block))
  {
    look.Visible = attributes->GetBlockVisibility(block);
  }
  if (attributes->HasBlockPickability(block))
  {
    look.Pickable = attributes->GetBlockPickability(block);
  }
  if (attributes->HasBlockOpacity(block))
  {
    look.HasOpacity = true;
    look.Opacity = attributes->GetBlockOpacity(block);
  }
  if (attributes->HasBlockColor(block))
  {
    look.HasColor = true;
    attributes->GetBlockColor(block, look.Color);
  }
}
}

BlockLooks GetBlockLooks(vtkCompositeDataDisplayAttributes* attributes, vtkDataObject* input)
{
  BlockLooks looks;
  if (!attributes)
  {
    return looks;
  }
  unsigned int nextIndex = 0;
  Visit(input, nextIndex, BlockLook(),
    [&](vtkDataObject* block, unsigned int index, BlockLook& look)
    {
      if (block)
      {
        ApplyOwn(attributes, block, look);
        if (!vtkDataObjectTree::SafeDownCast(block))
        {
          looks[index] = look;
        }
      }
    });
  return looks;
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
