// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves limits.md: with MESA_GL_VERSION_OVERRIDE=3.2 the mapper reports once that the context is
// too old. Version 3.3 is sufficient for streaks.
#include "RelevoLICView.h"
#include "RelevoTestMeshes.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkPolyDataMapper.h"

#include <iostream>

int TestAdaptiveLICMapperOldContext(int, char*[])
{
  RelevoCheck check;
  RelevoLICView view;
  RelevoErrors errors(view.Add(RelevoMeshes::Sphere(12, 10))->GetMapper());
  view.Scene->ResetCameras();
  const RelevoPicture picture = view.Draw();
  int major = 0;
  int minor = 0;
  vtkOpenGLRenderWindow::SafeDownCast(view.Scene->Window)->GetOpenGLVersion(major, minor);
  if (major > 3 || (major == 3 && minor > 3))
  {
    std::cout << "The context has OpenGL " << major << "." << minor << ": skipped." << std::endl;
    return 125;
  }
  if (major == 3 && minor == 3)
  {
    CHECK(errors.None());
    CHECK_NOT_EQUAL(picture.Colors, view.DrawColors().Colors);
  }
  else
  {
    CHECK(errors.Said("Refinement needs OpenGL 3.3"));
    CHECK_EQUAL(picture.CountForeground(), 0);
    view.Draw();
    CHECK(errors.None());
  }
  return check.GetResult();
}
