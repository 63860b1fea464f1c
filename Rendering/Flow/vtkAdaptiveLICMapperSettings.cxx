// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Settings, and what is copied from one mapper to another. They change live: no buffer is built
// again but for what is no-data.
#include "vtkAdaptiveLICMapperInternals.h"

#include "Image/ForwardedSettings.h"
#include "vtkImageData.h"

relevoLICSettingsMacro(vtkAdaptiveLICMapper);

relevoForwardMacro(vtkAdaptiveLICMapper, Enable, int);
relevoForwardMacro(vtkAdaptiveLICMapper, NumberOfSteps, int);
relevoForwardMacro(vtkAdaptiveLICMapper, StepSize, double);
relevoForwardMacro(vtkAdaptiveLICMapper, NormalizeVectors, int);
relevoForwardMacro(vtkAdaptiveLICMapper, EnhancedLIC, int);
relevoForwardMacro(vtkAdaptiveLICMapper, OrientedLIC, int);
relevoForwardMacro(vtkAdaptiveLICMapper, Phase, double);
relevoForwardMacro(vtkAdaptiveLICMapper, EnhanceContrast, int);
relevoForwardMacro(vtkAdaptiveLICMapper, LowLICContrastEnhancementFactor, double);
relevoForwardMacro(vtkAdaptiveLICMapper, HighLICContrastEnhancementFactor, double);
relevoForwardMacro(vtkAdaptiveLICMapper, LowColorContrastEnhancementFactor, double);
relevoForwardMacro(vtkAdaptiveLICMapper, HighColorContrastEnhancementFactor, double);
relevoForwardMacro(vtkAdaptiveLICMapper, AntiAlias, int);
relevoForwardMacro(vtkAdaptiveLICMapper, MaskThreshold, double);
relevoForwardMacro(vtkAdaptiveLICMapper, MaskOnSurface, int);
relevoForwardMacro(vtkAdaptiveLICMapper, MaskIntensity, double);
relevoForwardMacro(vtkAdaptiveLICMapper, NoDataMagnitude, double);
relevoForwardMacro(vtkAdaptiveLICMapper, LICIntensity, double);
relevoForwardMacro(vtkAdaptiveLICMapper, MapModeBias, double);

void vtkAdaptiveLICMapper::SetMaskColor(double red, double green, double blue)
{
  this->LICSettings->ChangeFor(
    this, [=](vtkLICSettings& settings) { settings.SetMaskColor(red, green, blue); });
}

double* vtkAdaptiveLICMapper::GetMaskColor()
{
  return this->LICSettings->GetMaskColor();
}

void vtkAdaptiveLICMapper::GetMaskColor(double color[3])
{
  this->LICSettings->GetMaskColor(color);
}

void vtkAdaptiveLICMapper::GetMaskColor(double& red, double& green, double& blue)
{
  this->LICSettings->GetMaskColor(red, green, blue);
}

void vtkAdaptiveLICMapper::SetColorModeToBlend()
{
  this->LICSettings->SetColorModeToBlend();
}

void vtkAdaptiveLICMapper::SetColorModeToMultiply()
{
  this->LICSettings->SetColorModeToMap();
}

void vtkAdaptiveLICMapper::SetColorModeToMap()
{
  this->LICSettings->SetColorModeToMap();
}

//------------------------------------------------------------------------------
// Noise

relevoForwardMacro(vtkAdaptiveLICMapper, NoiseDataSet, vtkImageData*);
relevoForwardMacro(vtkAdaptiveLICMapper, NoiseFileName, const char*);
relevoForwardMacro(vtkAdaptiveLICMapper, GenerateNoiseTexture, int);
relevoForwardMacro(vtkAdaptiveLICMapper, NoiseType, int);
relevoForwardMacro(vtkAdaptiveLICMapper, NoiseTextureSize, int);
relevoForwardMacro(vtkAdaptiveLICMapper, NoiseGrainSize, int);
relevoForwardMacro(vtkAdaptiveLICMapper, MinNoiseValue, double);
relevoForwardMacro(vtkAdaptiveLICMapper, MaxNoiseValue, double);
relevoForwardMacro(vtkAdaptiveLICMapper, NumberOfNoiseLevels, int);
relevoForwardMacro(vtkAdaptiveLICMapper, ImpulseNoiseProbability, double);
relevoForwardMacro(vtkAdaptiveLICMapper, ImpulseNoiseBackgroundValue, double);
relevoForwardMacro(vtkAdaptiveLICMapper, NoiseGeneratorSeed, int);

//------------------------------------------------------------------------------
// What the passes take

relevo::LICPassSettings vtkAdaptiveLICMapper::vtkInternals::GetPassSettings() const
{
  return relevo::MakeLICPassSettings(
    this->Root->LICSettings, std::max(this->AllVectors.Longest, 0.0), this->Noise.GetMean());
}

relevo::LICColoring vtkAdaptiveLICMapper::vtkInternals::GetColoring() const
{
  vtkLICSettings* settings = this->Root->LICSettings;
  return { settings->GetColorMode(), settings->GetLICIntensity(), settings->GetMapModeBias() };
}

bool vtkAdaptiveLICMapper::vtkInternals::StretchesColors() const
{
  return this->Root->LICSettings->EnhancesColorContrast();
}

// What is convolved: not how it is combined with colours.
void vtkAdaptiveLICMapper::vtkInternals::AddSettings(relevo::Dependencies& dependencies) const
{
  const relevo::LICPassSettings pass = this->GetPassSettings();
  vtkLICSettings* settings = this->Root->LICSettings;
  const auto add = [&dependencies](auto... values) { (dependencies.Add(values), ...); };
  add(this->Noise.GetVersion(), pass.Kernel.Steps, pass.Kernel.StepSize, pass.Kernel.Normalized,
    pass.Kernel.Oriented, pass.Kernel.Phase, pass.Enhanced, pass.Stretched, pass.StretchFactors.x,
    pass.StretchFactors.y, pass.NumberOfSmoothings, settings->GetMaskThreshold(),
    settings->GetMaskOnSurface(), settings->GetNoDataMagnitude());
}

//------------------------------------------------------------------------------

void vtkAdaptiveLICMapper::ShallowCopy(vtkAbstractMapper* mapper)
{
  this->Superclass::ShallowCopy(mapper);
  if (vtkAdaptiveLICMapper* other = vtkAdaptiveLICMapper::SafeDownCast(mapper))
  {
    this->SetInputArrayToProcess(0, other->GetInputArrayInformation(0));
    this->SetLICSettings(other->LICSettings);
  }
}

void vtkAdaptiveLICMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "LICSettings:\n";
  this->LICSettings->PrintSelf(os, indent.GetNextIndent());
  os << indent << "NumberOfConvolutions: " << this->NumberOfConvolutions << "\n";
}
