// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/ContextFacts.h"

#include "OpenGL/RelevoOpenGL.h"

#include <algorithm>
#include <cctype>
#include <cstring>

namespace relevo
{
namespace
{
bool HasExtension(const char* name)
{
  GLint count = 0;
  glGetIntegerv(GL_NUM_EXTENSIONS, &count);
  for (GLint i = 0; i < count; ++i)
  {
    if (!std::strcmp(reinterpret_cast<const char*>(glGetStringi(GL_EXTENSIONS, i)), name))
    {
      return true;
    }
  }
  return false;
}
}

std::string GetOpenGLRenderer()
{
  const GLubyte* name = glGetString(GL_RENDERER);
  return name ? reinterpret_cast<const char*>(name) : "";
}

bool IsHardwareRenderer()
{
  std::string renderer = GetOpenGLRenderer();
  std::transform(renderer.begin(), renderer.end(), renderer.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  for (const char* software :
    { "llvmpipe", "softpipe", "swr", "software", "swiftshader", "basic render", "gdi generic" })
  {
    if (renderer.find(software) != std::string::npos)
    {
      return false;
    }
  }
  return !renderer.empty();
}

bool HasBuffersOfThreeFloats()
{
  GLint major = 0;
  glGetIntegerv(GL_MAJOR_VERSION, &major);
  // Mesa's softpipe supports them, but reads wrong texels.
  return (major > 3 || HasExtension("GL_ARB_texture_buffer_object_rgb32")) &&
    GetOpenGLRenderer() != "softpipe";
}
}
