// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RelevoPrimitiveCount.h"

#include "OpenGL/RelevoOpenGL.h"

namespace RelevoPrimitiveCount
{
vtkIdType CountPrimitives(RelevoScene& scene)
{
  scene.Window->MakeCurrent();
  GLuint query = 0;
  GLuint count = 0;
  glGenQueries(1, &query);
  glBeginQuery(GL_PRIMITIVES_GENERATED, query);
  scene.Render();
  glEndQuery(GL_PRIMITIVES_GENERATED);
  glGetQueryObjectuiv(query, GL_QUERY_RESULT, &count);
  glDeleteQueries(1, &query);
  return static_cast<vtkIdType>(count);
}

vtkIdType CountTriangles(RelevoScene& scene)
{
  scene.Render(); // completes all updates after a change
  const vtkIdType all = CountPrimitives(scene);
  scene.GetActor(0)->VisibilityOff();
  const vtkIdType others = CountPrimitives(scene);
  scene.GetActor(0)->VisibilityOn();
  return all - others;
}
}
