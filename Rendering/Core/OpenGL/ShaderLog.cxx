// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/ShaderLog.h"

#include "OpenGL/RelevoOpenGL.h"

#include <algorithm>
#include <vector>

namespace relevo
{
namespace
{
template <typename GetParameter, typename GetLog>
std::string GetInfoLog(GLuint object, const GetParameter& getParameter, const GetLog& getLog)
{
  GLint length = 0;
  getParameter(object, GL_INFO_LOG_LENGTH, &length);
  std::vector<GLchar> text(static_cast<size_t>(std::max(length, 1)), '\0');
  getLog(object, static_cast<GLsizei>(text.size()), nullptr, text.data());
  return text.data();
}
}

unsigned int CompileShader(
  unsigned int stage, const char* name, const std::string& source, std::string& error)
{
  const GLchar* text = source.c_str();
  const GLuint shader = glCreateShader(stage);
  glShaderSource(shader, 1, &text, nullptr);
  glCompileShader(shader);
  GLint valid = GL_FALSE;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &valid);
  if (!valid)
  {
    error = std::string("a ") + name +
      " shader does not compile: " + GetInfoLog(shader, glGetShaderiv, glGetShaderInfoLog);
    glDeleteShader(shader);
    return 0;
  }
  return shader;
}

bool LinkProgram(unsigned int program, const char* name, std::string& error)
{
  glLinkProgram(program);
  GLint valid = GL_FALSE;
  glGetProgramiv(program, GL_LINK_STATUS, &valid);
  if (!valid)
  {
    error = std::string("a ") + name +
      " shader does not link: " + GetInfoLog(program, glGetProgramiv, glGetProgramInfoLog);
  }
  return valid != GL_FALSE;
}
}
