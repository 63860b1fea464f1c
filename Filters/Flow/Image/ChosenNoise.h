// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ChosenNoise
 * @brief   the noise that vtkLICSettings choose: an image of the user's, a file, or generated
 *
 * Private to the modules' own sources.
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
   * Has the texels that the settings choose; other settings than those of noise change nothing.
   * False, with GetError() as a sentence, if they cannot be had; the next call tries again.
   */
  bool Update(vtkLICSettings* settings);
  const NoiseTexels& GetTexels() const { return this->Texels; }
  const std::string& GetError() const { return this->Error; }

  /// How often there has been other noise.
  int GetVersion() const { return this->Version; }

private:
  bool ReadImage(vtkImageData* image, const std::string& what);
  bool ReadFile(const std::string& fileName);
  bool Generate(vtkLICSettings* settings);

  Dependencies Sources; // of the texels; on nothing where there are none
  int Version = 0;
  NoiseTexels Texels;
  std::string Error;
};
}

#endif
