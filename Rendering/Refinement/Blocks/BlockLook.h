// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @struct  BlockLook
 * @brief   how a block of a composite data set looks, by vtkCompositeDataDisplayAttributes
 */
#ifndef BlockLook_h
#define BlockLook_h

#include "RelevoRenderingRefinementModule.h" // for export macro

#include <map>

class vtkCompositeDataDisplayAttributes;
class vtkDataObject;

namespace relevo
{
/// What a block has of its own or from the blocks that it is in; else it is up to the actor.
struct BlockLook
{
  bool Visible = true;
  bool Pickable = true;
  bool HasOpacity = false;
  bool HasColor = false;
  double Opacity = 1.0;
  double Color[3] = { 1.0, 1.0, 1.0 };

  bool IsTranslucent() const { return this->HasOpacity && this->Opacity < 1.0; }
};

/// By the flat index of a leaf.
using BlockLooks = std::map<unsigned int, BlockLook>;

/// The looks of all leaves of a tree, or of the one data object that the input is; none without
/// attributes.
RELEVORENDERINGREFINEMENT_EXPORT BlockLooks GetBlockLooks(
  vtkCompositeDataDisplayAttributes* attributes, vtkDataObject* input);

/// The look of a leaf; the default one where it has none.
inline BlockLook FindLook(const BlockLooks& looks, unsigned int flatIndex)
{
  const auto look = looks.find(flatIndex);
  return look == looks.end() ? BlockLook() : look->second;
}

/**
 * The data object with a flat index: 0 is the input itself, a tree's nodes follow depth first.
 * False when there is no such index; an empty block is nullptr.
 */
bool FindBlock(vtkDataObject* input, unsigned int flatIndex, vtkDataObject*& block);
}

#endif
