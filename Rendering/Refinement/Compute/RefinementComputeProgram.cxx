// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Compute/RefinementComputeProgram.h"

#include "OpenGL/RelevoOpenGL.h"

#include "relevoComputeCS.h"

#include "OpenGL/ShaderLog.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"

namespace relevo
{
namespace
{
// The number of buffers that every OpenGL 4.3 supports in a compute shader.
constexpr GLuint MaximumBuffers = 8;
// The number of work groups along one axis that every OpenGL 4.3 supports.
constexpr int MaximumGroups = 65535;
}

bool RefinementComputeProgram::IsSupported()
{
  GLint major = 0;
  GLint minor = 0;
  glGetIntegerv(GL_MAJOR_VERSION, &major);
  glGetIntegerv(GL_MINOR_VERSION, &minor);
  return (major > 4 || (major == 4 && minor >= 3)) && glDispatchCompute != nullptr &&
    glMultiDrawElementsIndirect != nullptr;
}

bool RefinementComputeProgram::Build(const std::string& source)
{
  if (this->Handle && this->Source == source)
  {
    return true;
  }
  this->ReleaseGraphicsResources();
  this->Source = source;
  const GLuint shader =
    CompileShader(GL_COMPUTE_SHADER, "compute", relevoComputeCS + source, this->Error);
  if (!shader)
  {
    return false;
  }
  this->Handle = glCreateProgram();
  glAttachShader(this->Handle, shader);
  glDeleteShader(shader); // deleted together with the program
  if (!LinkProgram(this->Handle, "compute", this->Error))
  {
    this->ReleaseGraphicsResources();
    return false;
  }
  this->Error.clear();
  return true;
}

void RefinementComputeProgram::Begin(vtkOpenGLRenderWindow* window)
{
  window->GetShaderCache()->ReleaseCurrentShader();
}

void RefinementComputeProgram::End()
{
  for (GLuint binding = 0; binding < MaximumBuffers; ++binding)
  {
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, binding, 0);
  }
  glUseProgram(0);
  // Draw calls read the results as vertices, textures or commands, or they are read back later.
  glMemoryBarrier(GL_COMMAND_BARRIER_BIT | GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT |
    GL_TEXTURE_FETCH_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
}

void RefinementComputeProgram::Use(std::initializer_list<unsigned int> buffers)
{
  glUseProgram(this->Handle);
  GLuint binding = 0;
  for (unsigned int buffer : buffers)
  {
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, binding++, buffer);
  }
}

int RefinementComputeProgram::GetLocation(const char* name) const
{
  return glGetUniformLocation(this->Handle, name);
}

void RefinementComputeProgram::SetUniform(const char* name, int value)
{
  glUniform1i(this->GetLocation(name), value);
}

void RefinementComputeProgram::SetUniform(const char* name, float value)
{
  glUniform1f(this->GetLocation(name), value);
}

void RefinementComputeProgram::SetUniform(
  const char* name, const float* values, int components, int count)
{
  const GLint location = this->GetLocation(name);
  switch (components)
  {
    case 1:
      glUniform1fv(location, count, values);
      break;
    case 2:
      glUniform2fv(location, count, values);
      break;
    case 3:
      glUniform3fv(location, count, values);
      break;
    case 4:
      glUniform4fv(location, count, values);
      break;
    case 16:
      glUniformMatrix4fv(location, count, GL_FALSE, values);
      break;
    default:
      break;
  }
}

void RefinementComputeProgram::Dispatch(int elements)
{
  if (elements > 0)
  {
    this->SetUniform("relevoNumberOfElements", elements);
    const int groups = (elements - 1) / GroupSize + 1;
    const int rows = (groups - 1) / MaximumGroups + 1;
    glDispatchCompute(static_cast<GLuint>((groups - 1) / rows + 1), static_cast<GLuint>(rows), 1);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
  }
}

void RefinementComputeProgram::DispatchGroup()
{
  glDispatchCompute(1, 1, 1);
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

void RefinementComputeProgram::ReleaseGraphicsResources()
{
  if (this->Handle)
  {
    glDeleteProgram(this->Handle);
    this->Handle = 0;
  }
}
}
