// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves limits.md: in a context older than OpenGL 3.3, the mapper reports its requirements once.
// Run with MESA_GL_VERSION_OVERRIDE=3.2; skipped if the driver ignores it.
#include "RelevoScene.h"
#include "RelevoTestMeshes.h"

#include "vtkOpenGLRenderWindow.h"

#include <iostream>

int TestAdaptiveRefinementMapperOldContext(int, char*[])
{
  RelevoCheck check;
  RelevoScene scene(RelevoScene::Refining);
  vtkNew<vtkAdaptiveRefinement> recipe;
  scene.Add(RelevoMeshes::Cube(), recipe);
  RelevoErrors errors(scene.GetMapper(0));
  scene.ResetCameras();
  scene.Render();
  int major = 0;
  int minor = 0;
  vtkOpenGLRenderWindow::SafeDownCast(scene.Window)->GetOpenGLVersion(major, minor);
  if (major > 3 || (major == 3 && minor >= 3))
  {
    std::cout << "The context has OpenGL " << major << "." << minor << ": skipped." << std::endl;
    return 125;
  }
  CHECK(errors.Said("Refinement needs OpenGL 3.3"));
  CHECK_EQUAL(scene.GetMapper(0)->GetNumberOfDrawnTriangles(), 0);
  CHECK_EQUAL(RelevoPicture(scene.Window).CountForeground(), 0);
  scene.Render();
  CHECK(errors.None());
  return check.GetResult();
}
