// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   LICScreens
 * @brief   the screens of the views that were drawn last: one per renderer, actor and camera
 *
 * Private to the module's own sources.
 */
#ifndef LICScreens_h
#define LICScreens_h

#include "Passes/LICScreen.h"
#include "vtkType.h"

#include <map>
#include <tuple>

class vtkActor;
class vtkCamera;
class vtkRenderer;
class vtkWindow;

namespace relevo
{
class LICScreens
{
public:
  /// Return the screen of a view. A new screen may replace the least recently used one.
  LICScreen& Get(vtkRenderer* ren, vtkActor* act);
  /// Return the screen of a view, or nullptr if there is none with an image.
  LICScreen* Find(vtkRenderer* ren, vtkActor* act);

  vtkTypeInt64 GetMemorySize() const;
  void ReleaseGraphicsResources(vtkWindow* window);

private:
  using Key = std::tuple<vtkRenderer*, vtkActor*, vtkCamera*>;
  std::map<Key, LICScreen> Screens;
  unsigned long Use = 0;
};
}

#endif
