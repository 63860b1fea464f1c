// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   FrameWatch
 * @brief   tells the first drawing of a frame from further ones
 *
 * Depth peeling draws an actor several times per frame. Private to the module.
 */
#ifndef FrameWatch_h
#define FrameWatch_h

#include "vtkNew.h"
#include "vtkWeakPointer.h"

#include <vector>

class vtkCallbackCommand;
class vtkRenderer;

namespace relevo
{
class FrameWatch
{
public:
  FrameWatch();
  ~FrameWatch();
  FrameWatch(const FrameWatch&) = delete;
  void operator=(const FrameWatch&) = delete;

  /// Return whether a renderer has begun a frame since the last call for it.
  bool IsNewFrame(vtkRenderer* renderer);

private:
  struct Entry
  {
    vtkWeakPointer<vtkRenderer> Renderer;
    unsigned long Tag = 0; // of the observer
    bool HasBegun = false;
  };

  vtkNew<vtkCallbackCommand> Command;
  std::vector<Entry> Entries;
};
}

#endif
