// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @struct  LICPassSettings
 * @brief   parameters of the LIC passes on CPU and GPU
 *
 * Private to the modules.
 */
#ifndef LICPassSettings_h
#define LICPassSettings_h

#include "Image/LICKernel.h"
#include "RelevoFiltersFlowModule.h" // for export macro

#include <string> // for messages

class vtkLICSettings;

namespace relevo
{
/// Returns the kernel for steps of the given length, in pixels or other units of the positions.
RELEVOFILTERSFLOW_EXPORT LICKernel MakeLICKernel(vtkLICSettings* settings, double stepSize);

struct LICPassSettings
{
  float NoiseMean;
  LICKernel Kernel; // StepSize is for scaled vectors, see LICVectors
  bool Enhanced;
  bool Stretched;
  vec2 StretchFactors;
  int NumberOfSmoothings;
};

/**
 * `longest` is the length of the longest vector. Without normalization, the passes use vectors that
 * are divided by it.
 */
RELEVOFILTERSFLOW_EXPORT LICPassSettings MakeLICPassSettings(
  vtkLICSettings* settings, double longest, float noiseMean);

//@{
/// Return why the contrast of the LIC, or of the lightness of colours, cannot be enhanced with
/// these factors, as a sentence, or "".
RELEVOFILTERSFLOW_EXPORT std::string FindContrastError(vtkLICSettings* settings);
RELEVOFILTERSFLOW_EXPORT std::string FindColorContrastError(vtkLICSettings* settings);
//@}
}

#endif
