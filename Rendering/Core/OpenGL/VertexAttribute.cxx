// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/VertexAttribute.h"

#include "OpenGL/RelevoOpenGL.h"

#include "vtkShaderProgram.h"

namespace relevo
{
VertexAttribute::VertexAttribute(
  vtkShaderProgram* program, const char* name, unsigned int buffer, const Layout& layout)
  : Location(glGetAttribLocation(static_cast<GLuint>(program->GetHandle()), name))
{
  if (this->Location < 0)
  {
    return;
  }
  const GLuint index = static_cast<GLuint>(this->Location);
  const void* offset = reinterpret_cast<const void*>(layout.Offset);
  glBindBuffer(GL_ARRAY_BUFFER, buffer);
  glEnableVertexAttribArray(index);
  if (layout.Type == FLOAT)
  {
    glVertexAttribPointer(index, layout.Components, GL_FLOAT, GL_FALSE, layout.Stride, offset);
  }
  else
  {
    glVertexAttribIPointer(index, layout.Components, GL_UNSIGNED_INT, layout.Stride, offset);
  }
  glVertexAttribDivisor(index, layout.IsPerInstance ? 1 : 0);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
}

VertexAttribute::~VertexAttribute()
{
  if (this->Location >= 0)
  {
    const GLuint index = static_cast<GLuint>(this->Location);
    glVertexAttribDivisor(index, 0);
    glDisableVertexAttribArray(index);
  }
}
}
