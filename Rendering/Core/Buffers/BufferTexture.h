// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   BufferTexture
 * @brief   an array on the GPU that shaders read as a buffer texture
 *
 * Owns its data, or aliases a vertex buffer of VTK's so that coarse data are not stored twice.
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
   * Store values in texels of the given number of components. False when there are more texels
   * than a buffer texture may have, or the texture cannot be made.
   */
  bool Upload(vtkOpenGLRenderWindow* window, const std::vector<float>& values, int components);
  bool Upload(vtkOpenGLRenderWindow* window, const std::vector<int>& values, int components);
  bool Upload(
    vtkOpenGLRenderWindow* window, const std::vector<unsigned int>& values, int components = 1);
  //@}

  //@{
  /**
   * Take room for texels that compute shaders write; what is there is kept if it is as large.
   */
  bool ReserveIntegers(vtkOpenGLRenderWindow* window, size_t texels);
  bool ReserveFloats(vtkOpenGLRenderWindow* window, size_t texels, int components);
  //@}

  /// OpenGL's name of the buffer it owns; 0 for none.
  unsigned int GetHandle() const;

  /**
   * Read a vertex buffer of VTK's (floats, or unsigned bytes as fractions), as it was uploaded
   * last.
   */
  bool Alias(vtkOpenGLRenderWindow* window, vtkOpenGLVertexBufferObject* buffer);

  /**
   * Make the texture current and set the sampler uniform, if the program uses it.
   */
  void Activate(vtkShaderProgram* program, const std::string& sampler);
  void Deactivate();

  void ReleaseGraphicsResources(vtkWindow* window);

  /// Bytes of the data it owns.
  vtkTypeInt64 GetMemorySize() const { return this->MemorySize; }
  bool IsEmpty() const { return this->Texture == nullptr; }

  /// The message when a mesh does not fit, with the limit of the current context.
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
