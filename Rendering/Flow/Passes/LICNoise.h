// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   LICNoise
 * @brief   the noise of a mapper: generated, an image of the user's, or a file
 *
 * Private to the module's own sources.
 */
#ifndef LICNoise_h
#define LICNoise_h

#include "Image/NoiseTexels.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkTimeStamp.h"
#include "vtkType.h"

#include <string> // for the file's name

class vtkImageData;
class vtkLICNoiseSource;
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

  vtkNew<vtkLICNoiseSource> Source;
  vtkSmartPointer<vtkImageData> Image; // goes before the file
  std::string FileName;                // goes before the source
  bool Generated = true;               // by Source; else by one with its defaults

  /// Changes with whatever changes the noise.
  vtkMTimeType GetMTime() const;
  void Modified() { this->Time.Modified(); }

  /**
   * Make the noise. False, with GetError() as a sentence, if that fails.
   */
  bool Update();
  const std::string& GetError() const { return this->Error; }

  /// Of the noise, after Update().
  float GetMean() const { return this->Texels.GetMean(); }

  /// The noise as a texture of one float; nullptr if it cannot be made.
  vtkTextureObject* GetTexture(vtkOpenGLRenderWindow* window);
  void ReleaseGraphicsResources(vtkWindow* window);
  vtkTypeInt64 GetMemorySize() const;

private:
  bool TakeImage(vtkImageData* image, const std::string& what);
  bool ReadFile();
  bool Generate();

  vtkTimeStamp Time;
  vtkMTimeType UpdateTime = 0;
  std::string Error;
  NoiseTexels Texels;
  vtkSmartPointer<vtkTextureObject> Texture;
  vtkMTimeType TextureTime = 0;
};
}

#endif
