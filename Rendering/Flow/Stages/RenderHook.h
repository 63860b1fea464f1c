// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   RenderHook
 * @brief   something that a mapper does in place of drawing when VTK has it render
 *
 * Only VTK's Render() updates a mapper's pipeline piece by piece and makes its context the one in
 * use. Work that needs both before a picture begins goes this way. Private to the module's own
 * sources.
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

  /// Have an actor render a mapper, which calls Run() where it would draw.
  void RenderInstead(vtkRenderer* ren, vtkActor* act, vtkMapper* mapper, const Work& work)
  {
    this->Current = &work;
    act->Render(ren, mapper);
    this->Current = nullptr;
  }

  /// Do the work; false where there is none, and the mapper is to draw.
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
