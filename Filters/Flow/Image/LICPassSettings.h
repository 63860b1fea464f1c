// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @struct  LICPassSettings
 * @brief   the settings of line integral convolution as its passes need them, on the CPU and the
 * GPU
 *
 * Private to the modules' own sources.
 */
#ifndef LICPassSettings_h
#define LICPassSettings_h

#include "Image/LICKernel.h"
#include "RelevoFiltersFlowModule.h" // for export macro

#include <string> // for messages

class vtkLICSettings;

namespace relevo
{
/// The kernel of these settings, with steps of this length in the units of what is convolved.
RELEVOFILTERSFLOW_EXPORT LICKernel MakeLICKernel(vtkLICSettings* settings, double stepSize);

struct LICPassSettings
{
  float NoiseMean;
  LICKernel Kernel; // its StepSize for the vectors as LICVectors scales them
  bool Enhanced;
  bool Stretched;
  vec2 StretchFactors;
  int NumberOfSmoothings;
};

/**
 * For noise of this mean, and vectors that come, where they are not normalised, as shares of the
 * longest of them.
 */
RELEVOFILTERSFLOW_EXPORT LICPassSettings MakeLICPassSettings(
  vtkLICSettings* settings, double longest, float noiseMean);

//@{
/// Why the range of greys, or of the lightness of colours, cannot be stretched by these factors, as
/// a sentence; empty if it can.
RELEVOFILTERSFLOW_EXPORT std::string FindContrastError(vtkLICSettings* settings);
RELEVOFILTERSFLOW_EXPORT std::string FindColorContrastError(vtkLICSettings* settings);
//@}
}

#endif
