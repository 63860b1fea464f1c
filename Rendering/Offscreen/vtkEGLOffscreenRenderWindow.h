// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkEGLOffscreenRenderWindow
 * @brief   a render window that needs no display
 *
 * Draws into memory through an EGL context of its own, on the first device that offers OpenGL 3.2
 * core: a graphics card where there is one, else Mesa's software renderer. Use it like any
 * vtkRenderWindow, for pictures (vtkWindowToImageFilter) and measurements.
 *
 * OpenGL allows a thread either such windows or windows on a display at a time: delete the ones
 * before drawing with the others. Otherwise an ErrorEvent says so.
 *
 * VTK packages built for X11, such as Debian's, have no such window; VTK 9.4 and later choose one
 * by themselves when there is no display.
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
   * Create the context, when there is none yet. An ErrorEvent says why there can be none.
   */
  void Initialize() override;

  //@{
  /**
   * The window is always off-screen and its context its own.
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
   * Whether a context with OpenGL 3.2 core can be had: 1 or 0.
   */
  int SupportsOpenGL() override;

  /**
   * Whether the context draws on the machine itself: always 1.
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
