// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   RenderHook
 * @brief   work that a mapper does instead of drawing when VTK renders it
 *
 * Only VTK's Render() updates a mapper's pipeline piece by piece and makes its context current.
 * Work that needs both before an image begins uses this class. Private to the module's own sources.
 */
#ifndef RenderHook_h
#define RenderHook_h

#include "vtkActor.h"

#include <functional>

class vtkMapper;
class vtkRenderer;

namespace relevo
{
class RenderHook
{
public:
  using Work = std::function<void(vtkRenderer*, vtkActor*)>;

  /// Make an actor render a mapper, which calls Run() instead of drawing.
  void RenderInstead(vtkRenderer* ren, vtkActor* act, vtkMapper* mapper, const Work& work)
  {
    this->Current = &work;
    act->Render(ren, mapper);
    this->Current = nullptr;
  }

  /// Do the work. Return false if there is none, so that the mapper must draw.
  bool Run(vtkRenderer* ren, vtkActor* act) const
  {
    if (this->Current)
    {
      (*this->Current)(ren, act);
    }
    return this->Current != nullptr;
  }

private:
  const Work* Current = nullptr;
};
}

#endif
