// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @struct  BlockAttributes
 * @brief   the display attributes of a block of a composite data set
 *
 * They come from vtkCompositeDataDisplayAttributes. Private to the modules.
 */
#ifndef BlockAttributes_h
#define BlockAttributes_h

#include "RelevoRenderingCoreModule.h" // for export macro

#include <map>

class vtkCompositeDataDisplayAttributes;
class vtkDataObject;

namespace relevo
{
/// The attributes of a block, its own or those inherited from blocks that contain it. For the
/// others, the actor's apply.
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

/// The attributes of leaves by flat index.
using AttributesOfBlocks = std::map<unsigned int, BlockAttributes>;

/// Return the attributes of all leaves of a tree, or of the input if it is a single data object;
/// empty without display attributes.
RELEVORENDERINGCORE_EXPORT AttributesOfBlocks GetAttributesOfBlocks(
  vtkCompositeDataDisplayAttributes* attributes, vtkDataObject* input);

/// Return the attributes of a leaf, or the default ones.
inline BlockAttributes FindAttributes(const AttributesOfBlocks& blocks, unsigned int flatIndex)
{
  const auto block = blocks.find(flatIndex);
  return block == blocks.end() ? BlockAttributes() : block->second;
}

/**
 * Find the data object with a flat index: 0 is the input itself; a tree's nodes follow in
 * depth-first order. Return false if there is no such index. An empty block is nullptr.
 */
RELEVORENDERINGCORE_EXPORT bool FindBlock(
  vtkDataObject* input, unsigned int flatIndex, vtkDataObject*& block);
}

#endif
