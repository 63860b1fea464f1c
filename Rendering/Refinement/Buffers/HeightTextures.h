// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   HeightTextures
 * @brief   the height map of a displacement on the GPU: samples and their validity
 *
 * Private to the module.
 */
#ifndef HeightTextures_h
#define HeightTextures_h

#include "Changes/Dependencies.h" // for members
#include "vtkSmartPointer.h"      // for textures
#include "vtkType.h"              // for sizes

#include <string> // for errors

class vtkDisplacement;
class vtkHeightField;
class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkTextureObject;
class vtkWindow;

namespace relevo
{
class HeightTextures
{
public:
  HeightTextures();
  ~HeightTextures();
  HeightTextures(const HeightTextures&) = delete;
  void operator=(const HeightTextures&) = delete;

  /**
   * Upload the heights of a displacement if they have changed. Without a height map they are zero;
   * without a displacement (nullptr) there are none. Return false and set GetError() if the GPU
   * cannot hold them.
   */
  bool Upload(vtkOpenGLRenderWindow* window, vtkDisplacement* displacement);

  /// Return whether some samples are no data.
  bool HasValidity() const { return this->Validity != nullptr; }

  void Activate(vtkShaderProgram* program);
  void Deactivate();
  vtkTypeInt64 GetMemorySize() const { return this->MemorySize; }
  void ReleaseGraphicsResources(vtkWindow* window);
  const std::string& GetError() const { return this->Error; }

private:
  bool Create(
    vtkOpenGLRenderWindow* window, vtkHeightField* heights, const int size[2], bool withValidity);

  vtkSmartPointer<vtkTextureObject> Heights;
  vtkSmartPointer<vtkTextureObject> Validity;
  Dependencies HeightDependencies;
  vtkTypeInt64 MemorySize = 0;
  std::string Error;
};
}

#endif
