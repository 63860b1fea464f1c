// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Image/LICPassSettings.h"

#include "vtkLICSettings.h"
#include "vtkType.h"

#include <algorithm>
#include <sstream>

namespace relevo
{
namespace
{
std::string FindError(const char* range, double low, double high)
{
  std::ostringstream error;
  if (low + high >= 1.0)
  {
    error << "Low" << range << "ContrastEnhancementFactor " << low << " and High" << range
          << "ContrastEnhancementFactor " << high << " must add up to less than 1.";
  }
  return error.str();
}
}

LICKernel MakeLICKernel(vtkLICSettings* settings, double stepSize)
{
  LICKernel kernel;
  kernel.Steps = settings->GetNumberOfSteps();
  kernel.StepSize = static_cast<float>(std::min(stepSize, static_cast<double>(VTK_FLOAT_MAX)));
  kernel.Normalized = settings->GetNormalizeVectors() != 0;
  kernel.Oriented = settings->GetOrientedLIC() != 0;
  kernel.Phase = licWrapPhase(settings->GetPhase());
  return kernel;
}

LICPassSettings MakeLICPassSettings(vtkLICSettings* settings, double longest, float noiseMean)
{
  const double unit = settings->GetNormalizeVectors() ? 1.0 : longest;
  LICPassSettings pass;
  pass.NoiseMean = noiseMean;
  pass.Kernel = MakeLICKernel(settings, settings->GetStepSize() * unit);
  pass.Enhanced = settings->GetEnhancedLIC() != 0;
  pass.Stretched = settings->EnhancesLICContrast();
  pass.StretchFactors = vec2(static_cast<float>(settings->GetLowLICContrastEnhancementFactor()),
    static_cast<float>(settings->GetHighLICContrastEnhancementFactor()));
  pass.NumberOfSmoothings = settings->GetAntiAlias();
  return pass;
}

std::string FindContrastError(vtkLICSettings* settings)
{
  return FindError("LIC", settings->GetLowLICContrastEnhancementFactor(),
    settings->GetHighLICContrastEnhancementFactor());
}

std::string FindColorContrastError(vtkLICSettings* settings)
{
  return FindError("Color", settings->GetLowColorContrastEnhancementFactor(),
    settings->GetHighColorContrastEnhancementFactor());
}
}
