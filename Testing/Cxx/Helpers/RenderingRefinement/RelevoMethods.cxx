// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RelevoMethods.h"

#include "vtkOpenGLRenderWindow.h"

namespace RelevoMethods
{
std::vector<int> GetMethods()
{
  return { Mapper::METHOD_ARKFPI, Mapper::METHOD_ARK, Mapper::METHOD_DMR, Mapper::METHOD_SUAPT,
    Mapper::METHOD_UNIFORM };
}

const char* GetName(int method)
{
  static const char* const names[] = { "ARKFPI", "ARK", "DMR", "SUAPT", "HardwareTessellation",
    "Uniform" };
  return names[method];
}

bool HasTessellation()
{
  RelevoScene scene(RelevoScene::Refining);
  scene.Render();
  int major = 0;
  int minor = 0;
  vtkOpenGLRenderWindow::SafeDownCast(scene.Window)->GetOpenGLVersion(major, minor);
  return major >= 4;
}
}
