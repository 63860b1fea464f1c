// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ContextWatch
 * @brief   has a mapper's resources released in the context that they are in, before that goes
 *
 * VTK keeps the callbacks that windows call to itself; a texture object has one. Private to the
 * module.
 */
#ifndef ContextWatch_h
#define ContextWatch_h

#include "RelevoRenderingCoreModule.h" // for export macro
#include "vtkTextureObject.h"

#include <functional> // for OnRelease

namespace relevo
{
class RELEVORENDERINGCORE_EXPORT ContextWatch : public vtkTextureObject
{
public:
  static ContextWatch* New();
  vtkTypeMacro(ContextWatch, vtkTextureObject);

  /// Called with the window whose context is current then: before another one is set, before the
  /// window finalizes its context, and by Release().
  std::function<void(vtkWindow*)> OnRelease;

  /**
   * Make the context of SetContext() current for a call of OnRelease. False, without a call, if
   * that has been released already, or is being released.
   */
  bool Release();

  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  ContextWatch() = default;
  ~ContextWatch() override = default;

private:
  ContextWatch(const ContextWatch&) = delete;
  void operator=(const ContextWatch&) = delete;

  bool IsReleasing = false;
  bool HasReleased = false;
};
}

#endif
