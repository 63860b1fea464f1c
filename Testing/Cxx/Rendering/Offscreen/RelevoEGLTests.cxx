// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Runs tests with vtkEGLOffscreenRenderWindow if RELEVO_TEST_WINDOW=EGL. If
// RELEVO_TEST_DEBUG_OUTPUT=1 too, OpenGL's messages on errors and undefined behaviour are printed
// with the prefix "OpenGL says". MESA_DEBUG=context makes Mesa report everything.
#include "OpenGL/RelevoOpenGL.h"
#include "vtkEGLOffscreenRenderWindow.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkVersion.h"

#include <cstdlib>
#include <cstring>
#include <iostream>

#ifndef VTK_FUTURE_CONST // since VTK 9.4
#define VTK_FUTURE_CONST
#endif

namespace
{
bool IsAsking = false; // raises an error to see whether it is reported
bool IsTold = false;

void GLAPIENTRY Tell(
  GLenum, GLenum type, GLuint, GLenum, GLsizei, const GLchar* message, const void*)
{
  if (type != GL_DEBUG_TYPE_ERROR && type != GL_DEBUG_TYPE_UNDEFINED_BEHAVIOR &&
    type != GL_DEBUG_TYPE_DEPRECATED_BEHAVIOR && type != GL_DEBUG_TYPE_PORTABILITY)
  {
    return;
  }
  IsTold = true;
  if (!IsAsking)
  {
    std::cerr << "OpenGL says: " << message << std::endl;
  }
}

void TurnDebugOutputOn()
{
  IsTold = false;
  if (glDebugMessageCallback)
  {
    glEnable(GL_DEBUG_OUTPUT);
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    glDebugMessageCallback(Tell, nullptr);
    IsAsking = true;
    glEnable(GL_NO_ERROR); // not a valid capability
    glGetError();
    IsAsking = false;
  }
  if (!IsTold)
  {
    std::cerr << "no debug output" << std::endl;
  }
}

vtkObject* CreateWindow()
{
  vtkEGLOffscreenRenderWindow* window = vtkEGLOffscreenRenderWindow::New();
  if (std::getenv("RELEVO_TEST_DEBUG_OUTPUT"))
  {
    window->Initialize();
    TurnDebugOutputOn();
  }
  return window;
}

class EGLFactory : public vtkObjectFactory
{
public:
  static EGLFactory* New();
  vtkTypeMacro(EGLFactory, vtkObjectFactory);
  const char* GetVTKSourceVersion() VTK_FUTURE_CONST override { return VTK_SOURCE_VERSION; }
  const char* GetDescription() VTK_FUTURE_CONST override { return "windows without a display"; }

protected:
  EGLFactory()
  {
    this->RegisterOverride("vtkRenderWindow", "vtkEGLOffscreenRenderWindow",
      "a window without a display", 1, CreateWindow);
  }
};
vtkStandardNewMacro(EGLFactory);

const bool IsInstalled = []()
{
  const char* window = std::getenv("RELEVO_TEST_WINDOW");
  if (window && !std::strcmp(window, "EGL"))
  {
    vtkObjectFactory::SetAllEnableFlags(0, "vtkRenderWindow");
    vtkNew<EGLFactory> factory;
    vtkObjectFactory::RegisterFactory(factory);
  }
  return true;
}();
}
