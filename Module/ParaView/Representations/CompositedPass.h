// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   CompositedPass
 * @brief   makes IceT draw the props of a render state, at the full size of the window
 *
 * ParaView's pass inside of IceT draws the visible props of the renderer, and in interactive frames
 * at a reduced size. While this object exists, IceT draws the opaque props of the render state that
 * it gets, and overlays.
 *
 * Private to the module.
 */
#ifndef CompositedPass_h
#define CompositedPass_h

#include "vtkSmartPointer.h"

class vtkIceTCompositePass;
class vtkRenderPass;

namespace relevo
{
class CompositedPass
{
public:
  /// Look for IceT in the passes of a renderer, from the outermost one.
  explicit CompositedPass(vtkRenderPass* outermost);
  ~CompositedPass();
  CompositedPass(const CompositedPass&) = delete;
  void operator=(const CompositedPass&) = delete;

  /// Return whether IceT is one of the passes.
  bool IsFound() const { return this->IceT != nullptr; }

private:
  vtkIceTCompositePass* IceT = nullptr;
  vtkSmartPointer<vtkRenderPass> Previous;
  int Reduction = 1; // of the size, before
};
}

#endif
