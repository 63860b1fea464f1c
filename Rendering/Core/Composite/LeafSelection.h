// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   LeafSelection
 * @brief   tells a renderer's hardware selector which leaf of a prop is drawn, if it selects
 *
 * Private to the modules.
 */
#ifndef LeafSelection_h
#define LeafSelection_h

#include "RelevoRenderingCoreModule.h" // for export macro

class vtkHardwareSelector;
class vtkRenderer;

namespace relevo
{
class RELEVORENDERINGCORE_EXPORT LeafSelection
{
public:
  /// The prop is drawn as long as the object lives.
  explicit LeafSelection(vtkRenderer* renderer);
  ~LeafSelection();
  LeafSelection(const LeafSelection&) = delete;
  void operator=(const LeafSelection&) = delete;

  /// Before a leaf is drawn.
  void Begin(unsigned int flatIndex);

private:
  vtkHardwareSelector* Selector;
};
}

#endif
