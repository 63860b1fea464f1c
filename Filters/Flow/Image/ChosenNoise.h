// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ChosenNoise
 * @brief   the noise that vtkLICSettings select: an image, a file, or generated noise
 *
 * Private to the modules.
 */
#ifndef ChosenNoise_h
#define ChosenNoise_h

#include "Changes/Dependencies.h"    // for members
#include "Image/NoiseTexels.h"       // for members
#include "RelevoFiltersFlowModule.h" // for export macro

#include <string> // for members

class vtkImageData;
class vtkLICSettings;

namespace relevo
{
class RELEVOFILTERSFLOW_EXPORT ChosenNoise
{
public:
  /**
   * Reads or generates the texels if settings of noise have changed. Returns false if that fails,
   * with a sentence as GetError(). The next call tries again.
   */
  bool Update(vtkLICSettings* settings);
  const NoiseTexels& GetTexels() const { return this->Texels; }
  const std::string& GetError() const { return this->Error; }

  /// Returns a number that changes with the noise.
  int GetVersion() const { return this->Version; }

private:
  bool ReadImage(vtkImageData* image, const std::string& what);
  bool ReadFile(const std::string& fileName);
  bool Generate(vtkLICSettings* settings);

  Dependencies Sources; // dependencies of the texels; empty without texels
  int Version = 0;
  NoiseTexels Texels;
  std::string Error;
};
}

#endif
