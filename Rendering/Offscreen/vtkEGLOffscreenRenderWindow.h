// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkEGLOffscreenRenderWindow
 * @brief   a render window that needs no display
 *
 * Draws into memory through an EGL context, on the first device that offers OpenGL 3.2 core: a
 * graphics card if there is one, otherwise Mesa's software renderer. Use it like any
 * vtkRenderWindow, for screenshots (vtkWindowToImageFilter) and measurements.
 *
 * OpenGL allows a thread to use either such windows or windows on a display at a time. Delete the
 * windows of one kind before you draw with the other; otherwise an ErrorEvent reports it.
 *
 * VTK packages built for X11, such as Debian's, have no off-screen window of this kind. VTK 9.4 and
 * later choose one automatically when there is no display.
 *
 * @sa vtkRenderWindow vtkWindowToImageFilter
 */
#ifndef vtkEGLOffscreenRenderWindow_h
#define vtkEGLOffscreenRenderWindow_h

#include "RelevoRenderingOffscreenModule.h" // for export macro
#include "vtkGenericOpenGLRenderWindow.h"

#include <memory> // for std::unique_ptr

class RELEVORENDERINGOFFSCREEN_EXPORT vtkEGLOffscreenRenderWindow
  : public vtkGenericOpenGLRenderWindow
{
public:
  static vtkEGLOffscreenRenderWindow* New();
  vtkTypeMacro(vtkEGLOffscreenRenderWindow, vtkGenericOpenGLRenderWindow);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Create the context if there is none yet. If it cannot be created, an ErrorEvent reports the
   * reason.
   */
  void Initialize() override;

  //@{
  /**
   * These methods are overridden because the window is always off-screen and owns its context.
   */
  void MakeCurrent() override;
  bool IsCurrent() override;
  void PushContext() override;
  void PopContext() override;
  void Render() override;
  void Finalize() override;
  void OpenGLInit() override;
  void OpenGLInitContext() override;
  void* GetGenericContext() override;
  //@}

  /**
   * Return 1 if a context with OpenGL 3.2 core can be created, otherwise 0.
   */
  int SupportsOpenGL() override;

  /**
   * Return whether the context draws on the local machine: always 1.
   */
  vtkTypeBool IsDirect() override;

protected:
  vtkEGLOffscreenRenderWindow();
  ~vtkEGLOffscreenRenderWindow() override;

private:
  vtkEGLOffscreenRenderWindow(const vtkEGLOffscreenRenderWindow&) = delete;
  void operator=(const vtkEGLOffscreenRenderWindow&) = delete;

  void CreateContext();

  struct EGLContextHolder;
  std::unique_ptr<EGLContextHolder> Context;
};

#endif
