// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Compute/RefinementComputeBuffer.h"

#include "OpenGL/RelevoOpenGL.h"

#include <algorithm>

namespace relevo
{
namespace
{
// VTK does not use this binding.
constexpr GLenum Target = GL_COPY_WRITE_BUFFER;

GLint64 GetMaximumBytes()
{
  GLint64 most = 0;
  glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &most);
  return most;
}

class Binding
{
public:
  explicit Binding(unsigned int handle) { glBindBuffer(Target, handle); }
  ~Binding() { glBindBuffer(Target, 0); }
};
}

std::string RefinementComputeBuffer::GetTooLarge(const std::string& what)
{
  return "the storage buffers of this OpenGL, of at most " + std::to_string(GetMaximumBytes()) +
    " bytes, are too small for " + what;
}

bool RefinementComputeBuffer::Resize(std::size_t bytes)
{
  return this->Upload(nullptr, bytes);
}

bool RefinementComputeBuffer::Upload(const void* values, std::size_t bytes)
{
  const std::size_t size = std::max<std::size_t>(bytes, 16); // empty buffers cannot be bound
  if (static_cast<GLint64>(size) > GetMaximumBytes())
  {
    return false;
  }
  if (!this->Handle)
  {
    glGenBuffers(1, &this->Handle);
  }
  const Binding binding(this->Handle);
  if (this->Size != static_cast<vtkTypeInt64>(size))
  {
    glBufferData(Target, static_cast<GLsizeiptr>(size), nullptr, GL_DYNAMIC_COPY);
    this->Size = static_cast<vtkTypeInt64>(size);
  }
  if (values && bytes > 0)
  {
    glBufferSubData(Target, 0, static_cast<GLsizeiptr>(bytes), values);
  }
  return true;
}

void RefinementComputeBuffer::Clear()
{
  const Binding binding(this->Handle);
  const GLuint zero = 0;
  glClearBufferData(Target, GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, &zero);
}

void RefinementComputeBuffer::ReadBuffer(
  unsigned int handle, std::size_t offset, void* values, std::size_t bytes)
{
  const Binding binding(handle);
  glGetBufferSubData(Target, static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(bytes), values);
}

void RefinementComputeBuffer::ReleaseGraphicsResources()
{
  if (this->Handle)
  {
    glDeleteBuffers(1, &this->Handle);
    this->Handle = 0;
    this->Size = 0;
  }
}
}
