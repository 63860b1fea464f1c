// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   LICNoise
 * @brief   the noise of a mapper as a texture
 *
 * Private to the module's own sources.
 */
#ifndef LICNoise_h
#define LICNoise_h

#include "Image/ChosenNoise.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <string> // for messages

class vtkLICSettings;
class vtkOpenGLRenderWindow;
class vtkTextureObject;
class vtkWindow;

namespace relevo
{
class LICNoise
{
public:
  LICNoise();
  ~LICNoise();
  LICNoise(const LICNoise&) = delete;
  void operator=(const LICNoise&) = delete;

  /**
   * Update the noise that the settings choose. If that fails, return false and set GetError() to a
   * sentence.
   */
  bool Update(vtkLICSettings* settings) { return this->Chosen.Update(settings); }
  const std::string& GetError() const { return this->Chosen.GetError(); }

  /// Return the mean and the version of the noise, after Update().
  float GetMean() const { return this->Chosen.GetTexels().GetMean(); }
  int GetVersion() const { return this->Chosen.GetVersion(); }

  /// Return the noise as a texture of one float; nullptr if it cannot be created.
  vtkTextureObject* GetTexture(vtkOpenGLRenderWindow* window);
  void ReleaseGraphicsResources(vtkWindow* window);
  vtkTypeInt64 GetMemorySize() const;

private:
  ChosenNoise Chosen;
  vtkSmartPointer<vtkTextureObject> Texture;
  int TextureVersion = 0;
};
}

#endif
