// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ContextWatch
 * @brief   releases a mapper's resources in their context before the context is destroyed
 *
 * VTK does not expose the callbacks that windows call; a texture object has one. Private to the
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

  /// The function that releases resources in the window, whose context is current. It is called
  /// before another window is set, before the window finalizes its context, and by Release().
  std::function<void(vtkWindow*)> OnRelease;

  /**
   * Make the context of SetContext() current and call OnRelease. Return false, without a call, if
   * the resources have been released already or are being released.
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
