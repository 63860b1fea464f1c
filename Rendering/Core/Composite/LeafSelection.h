// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   LeafSelection
 * @brief   passes the index of the leaf being drawn to a renderer's hardware selector
 *
 * Without a selection, nothing happens. Private to the modules.
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
  /// Begin the prop; the destructor ends it.
  explicit LeafSelection(vtkRenderer* renderer);
  ~LeafSelection();
  LeafSelection(const LeafSelection&) = delete;
  void operator=(const LeafSelection&) = delete;

  /// Set the index before a leaf is drawn.
  void Begin(unsigned int flatIndex);

private:
  vtkHardwareSelector* Selector;
};
}

#endif
