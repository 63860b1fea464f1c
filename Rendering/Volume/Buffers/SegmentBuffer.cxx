// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Buffers/SegmentBuffer.h"

#include "OpenGL/RelevoOpenGL.h"

namespace relevo
{
namespace
{
// VTK does not use this binding.
constexpr GLenum Binding = GL_COPY_WRITE_BUFFER;
constexpr GLsizeiptr WordSize = sizeof(std::uint32_t);

void ReadWords(unsigned int buffer, size_t first, size_t count, std::uint32_t* words)
{
  glBindBuffer(Binding, buffer);
  glGetBufferSubData(Binding, static_cast<GLintptr>(first) * WordSize,
    static_cast<GLsizeiptr>(count) * WordSize, words);
  glBindBuffer(Binding, 0);
}
}

bool SegmentBuffer::IsSupported()
{
  GLint major = 0;
  GLint minor = 0;
  glGetIntegerv(GL_MAJOR_VERSION, &major);
  glGetIntegerv(GL_MINOR_VERSION, &minor);
  return (major > 4 || (major == 4 && minor >= 3)) && glMemoryBarrier != nullptr;
}

bool SegmentBuffer::Begin(size_t words)
{
  GLint64 most = 0;
  glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &most);
  const auto size = static_cast<GLsizeiptr>(words + 1) * WordSize;
  if (size > most)
  {
    return false;
  }
  if (!this->Handle)
  {
    glGenBuffers(1, &this->Handle);
  }
  glBindBuffer(Binding, this->Handle);
  if (this->Size != size)
  {
    glBufferData(Binding, size, nullptr, GL_DYNAMIC_READ);
    this->Size = size;
  }
  const std::uint32_t none = 0;
  glBufferSubData(Binding, 0, WordSize, &none);
  glBindBuffer(Binding, 0);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, this->Handle);
  return true;
}

size_t SegmentBuffer::End()
{
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, 0);
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  std::uint32_t records = 0;
  ReadWords(this->Handle, 0, 1, &records);
  return records;
}

std::vector<std::uint32_t> SegmentBuffer::Read(size_t words) const
{
  std::vector<std::uint32_t> read(words);
  ReadWords(this->Handle, 1, words, read.data());
  return read;
}

void SegmentBuffer::ReleaseGraphicsResources()
{
  if (this->Handle)
  {
    glDeleteBuffers(1, &this->Handle);
    this->Handle = 0;
    this->Size = 0;
  }
}
}
