// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Buffers/BufferTexture.h"

#include "OpenGL/RelevoOpenGL.h"

#include "vtkOpenGLBufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLVertexBufferObject.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <algorithm>

namespace relevo
{
namespace
{
size_t GetMaximumTexels()
{
  GLint most = 0;
  glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &most);
  return static_cast<size_t>(most);
}
}

BufferTexture::BufferTexture() = default;
BufferTexture::~BufferTexture() = default;

std::string BufferTexture::GetTooLarge()
{
  return "the mesh is larger than the buffer textures of this OpenGL, of at most " +
    std::to_string(GetMaximumTexels()) +
    " texels; draw it as several blocks of a vtkMultiBlockDataSet";
}

bool BufferTexture::Upload(
  vtkOpenGLRenderWindow* window, const std::vector<float>& values, int components)
{
  return this->UploadValues(window, values, components, VTK_FLOAT, 0, 0);
}

bool BufferTexture::Upload(
  vtkOpenGLRenderWindow* window, const std::vector<int>& values, int components)
{
  return components == 4
    ? this->UploadValues(window, values, 4, VTK_INT, GL_RGBA_INTEGER, GL_RGBA32I)
    : this->UploadValues(window, values, 1, VTK_INT, GL_RED_INTEGER, GL_R32I);
}

bool BufferTexture::Upload(
  vtkOpenGLRenderWindow* window, const std::vector<unsigned int>& values, int components)
{
  switch (components)
  {
    case 4:
      return this->UploadValues(window, values, 4, VTK_UNSIGNED_INT, GL_RGBA_INTEGER, GL_RGBA32UI);
    case 2:
      return this->UploadValues(window, values, 2, VTK_UNSIGNED_INT, GL_RG_INTEGER, GL_RG32UI);
    default:
      return this->UploadValues(window, values, 1, VTK_UNSIGNED_INT, GL_RED_INTEGER, GL_R32UI);
  }
}

template <typename T>
bool BufferTexture::UploadValues(vtkOpenGLRenderWindow* window, const std::vector<T>& values,
  int components, int dataType, int integerFormat, int integerInternalFormat)
{
  if (!this->Buffer)
  {
    this->Buffer = vtkSmartPointer<vtkOpenGLBufferObject>::New();
    this->Buffer->SetType(vtkOpenGLBufferObject::TextureBuffer);
  }
  const std::vector<T> none(static_cast<size_t>(components), T(0));
  const std::vector<T>& data = values.empty() ? none : values;
  this->MemorySize = static_cast<vtkTypeInt64>(data.size() * sizeof(T));
  return this->Buffer->Upload(data, vtkOpenGLBufferObject::TextureBuffer) &&
    this->CreateTexture(window, data.size() / components, components, dataType, this->Buffer,
      integerFormat, integerInternalFormat);
}

void BufferTexture::Download(std::vector<unsigned int>& values)
{
  values.resize(static_cast<size_t>(this->MemorySize) / sizeof(unsigned int));
  if (!values.empty() && this->Buffer->Bind())
  {
    glGetBufferSubData(
      GL_TEXTURE_BUFFER, 0, static_cast<GLsizeiptr>(this->MemorySize), values.data());
    this->Buffer->Release();
  }
}

bool BufferTexture::ReserveIntegers(vtkOpenGLRenderWindow* window, size_t texels)
{
  const size_t size = std::max<size_t>(texels, 1) * sizeof(unsigned int);
  return this->MemorySize == static_cast<vtkTypeInt64>(size) ||
    this->Upload(window, std::vector<unsigned int>(texels));
}

bool BufferTexture::ReserveFloats(vtkOpenGLRenderWindow* window, size_t texels, int components)
{
  const size_t values = std::max<size_t>(texels, 1) * static_cast<size_t>(components);
  return this->MemorySize == static_cast<vtkTypeInt64>(values * sizeof(float)) ||
    this->Upload(window, std::vector<float>(values), components);
}

unsigned int BufferTexture::GetHandle() const
{
  return this->Buffer ? static_cast<unsigned int>(this->Buffer->GetHandle()) : 0;
}

bool BufferTexture::Alias(vtkOpenGLRenderWindow* window, vtkOpenGLVertexBufferObject* buffer)
{
  const vtkMTimeType time = buffer->GetUploadTime();
  if (this->Texture && this->AliasTime == time)
  {
    return true; // uploads have unique times
  }
  const bool bytes = buffer->GetDataType() == VTK_UNSIGNED_CHAR;
  // Rows of bytes are padded to four.
  const bool created = this->CreateTexture(window, buffer->GetNumberOfTuples(),
    bytes ? 4 : static_cast<int>(buffer->GetNumberOfComponents()), buffer->GetDataType(), buffer, 0,
    0);
  this->AliasTime = created ? time : 0;
  return created;
}

bool BufferTexture::CreateTexture(vtkOpenGLRenderWindow* window, size_t texels, int components,
  int dataType, vtkOpenGLBufferObject* buffer, int integerFormat, int integerInternalFormat)
{
  if (texels > GetMaximumTexels())
  {
    return false;
  }
  if (!this->Texture)
  {
    this->Texture = vtkSmartPointer<vtkTextureObject>::New();
  }
  this->Texture->SetContext(window);
  // otherwise the format of another number of components would stay
  this->Texture->ResetFormatAndType();
  if (integerFormat)
  {
    // VTK would choose a float format by default.
    this->Texture->SetInternalFormat(integerInternalFormat);
    this->Texture->SetFormat(integerFormat);
  }
  return this->Texture->CreateTextureBuffer(
    static_cast<unsigned int>(texels), components, dataType, buffer);
}

void BufferTexture::Activate(vtkShaderProgram* program, const std::string& sampler)
{
  if (this->Texture && program->IsUniformUsed(sampler.c_str()))
  {
    this->Texture->Activate();
    program->SetUniformi(sampler.c_str(), this->Texture->GetTextureUnit());
  }
}

void BufferTexture::Deactivate()
{
  if (this->Texture)
  {
    this->Texture->Deactivate();
  }
}

void BufferTexture::ReleaseGraphicsResources(vtkWindow* window)
{
  if (this->Texture)
  {
    this->Texture->ReleaseGraphicsResources(window);
    this->Texture = nullptr;
  }
  if (this->Buffer)
  {
    this->Buffer->ReleaseGraphicsResources();
    this->Buffer = nullptr;
  }
  this->MemorySize = 0;
  this->AliasTime = 0;
}
}
