// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @struct  BlockAttributes
 * @brief   the display attributes of a block of a composite data set
 *
 * From vtkCompositeDataDisplayAttributes. Private to the modules.
 */
#ifndef BlockAttributes_h
#define BlockAttributes_h

#include "RelevoRenderingCoreModule.h" // for export macro

#include <map>

class vtkCompositeDataDisplayAttributes;
class vtkDataObject;

namespace relevo
{
/// The attributes of a block, its own or those of blocks that contain it; the actor has the rest.
struct BlockAttributes
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
using AttributesOfBlocks = std::map<unsigned int, BlockAttributes>;

/// The attributes of all leaves of a tree, or of the one data object that the input is; none where
/// there are no display attributes.
RELEVORENDERINGCORE_EXPORT AttributesOfBlocks GetAttributesOfBlocks(
  vtkCompositeDataDisplayAttributes* attributes, vtkDataObject* input);

/// Those of a leaf; the default one where it has none.
inline BlockAttributes FindAttributes(const AttributesOfBlocks& blocks, unsigned int flatIndex)
{
  const auto block = blocks.find(flatIndex);
  return block == blocks.end() ? BlockAttributes() : block->second;
}

/**
 * The data object with a flat index: 0 is the input itself, a tree's nodes follow depth first.
 * False when there is no such index; an empty block is nullptr.
 */
RELEVORENDERINGCORE_EXPORT bool FindBlock(
  vtkDataObject* input, unsigned int flatIndex, vtkDataObject*& block);
}

#endif
