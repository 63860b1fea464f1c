// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Tests run again with RELEVO_TEST_WINDOW=EGL: their windows are vtkEGLOffscreenRenderWindow.
#include "vtkEGLOffscreenRenderWindow.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkVersion.h"

#include <cstdlib>
#include <cstring>

#ifndef VTK_FUTURE_CONST // from VTK 9.4 on
#define VTK_FUTURE_CONST
#endif

namespace
{
VTK_CREATE_CREATE_FUNCTION(vtkEGLOffscreenRenderWindow);

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
      "a window without a display", 1, vtkObjectFactoryCreatevtkEGLOffscreenRenderWindow);
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
