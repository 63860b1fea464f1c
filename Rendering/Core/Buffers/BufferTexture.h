// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   BufferTexture
 * @brief   an array on the GPU that shaders read as a buffer texture
 *
 * It owns its data, or aliases a vertex buffer of VTK so that coarse data are not stored twice.
 * Private to the module.
 */
#ifndef BufferTexture_h
#define BufferTexture_h

#include "RelevoRenderingCoreModule.h" // for export macro
#include "vtkNew.h"                    // for Buffer
#include "vtkSmartPointer.h"           // for Texture
#include "vtkType.h"                   // for vtkTypeInt64

#include <string> // for uniform names
#include <vector> // for data

class vtkOpenGLBufferObject;
class vtkOpenGLRenderWindow;
class vtkOpenGLVertexBufferObject;
class vtkShaderProgram;
class vtkTextureObject;
class vtkWindow;

namespace relevo
{
class RELEVORENDERINGCORE_EXPORT BufferTexture
{
public:
  BufferTexture();
  ~BufferTexture();
  BufferTexture(const BufferTexture&) = delete;
  void operator=(const BufferTexture&) = delete;

  //@{
  /**
   * Store values in texels of the given number of components. Return false if there are more texels
   * than a buffer texture may have, or if the texture cannot be created.
   */
  bool Upload(vtkOpenGLRenderWindow* window, const std::vector<float>& values, int components);
  bool Upload(vtkOpenGLRenderWindow* window, const std::vector<int>& values, int components);
  bool Upload(
    vtkOpenGLRenderWindow* window, const std::vector<unsigned int>& values, int components = 1);
  //@}

  /// Read the unsigned integers of the owned buffer. This call waits for the GPU.
  void Download(std::vector<unsigned int>& values);

  //@{
  /**
   * Allocate texels that compute shaders write. The content is kept if the size is the same.
   */
  bool ReserveIntegers(vtkOpenGLRenderWindow* window, size_t texels);
  bool ReserveFloats(vtkOpenGLRenderWindow* window, size_t texels, int components);
  //@}

  /// Return OpenGL's name of the owned buffer; 0 for none.
  unsigned int GetHandle() const;

  /**
   * Read the last upload of VTK's vertex buffer (floats, or unsigned bytes as fractions).
   */
  bool Alias(vtkOpenGLRenderWindow* window, vtkOpenGLVertexBufferObject* buffer);

  /**
   * Activate the texture and set the sampler uniform, if the program uses it.
   */
  void Activate(vtkShaderProgram* program, const std::string& sampler);
  void Deactivate();

  void ReleaseGraphicsResources(vtkWindow* window);

  /// Return the number of bytes of the owned data.
  vtkTypeInt64 GetMemorySize() const { return this->MemorySize; }
  bool IsEmpty() const { return this->Texture == nullptr; }

  /// Return the message for a mesh that does not fit, with the limit of the current context.
  static std::string GetTooLarge();

private:
  template <typename T>
  bool UploadValues(vtkOpenGLRenderWindow* window, const std::vector<T>& values, int components,
    int dataType, int integerFormat, int integerInternalFormat);
  bool CreateTexture(vtkOpenGLRenderWindow* window, size_t texels, int components, int dataType,
    vtkOpenGLBufferObject* buffer, int integerFormat, int integerInternalFormat);

  vtkSmartPointer<vtkOpenGLBufferObject> Buffer;
  vtkSmartPointer<vtkTextureObject> Texture;
  vtkTypeInt64 MemorySize = 0;
  vtkMTimeType AliasTime = 0; // of the upload that is read
};
}

#endif
