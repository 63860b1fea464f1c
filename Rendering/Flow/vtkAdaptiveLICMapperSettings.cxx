// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Settings, and what is copied from one mapper to another. They change live: no buffer is built
// again but for what is no-data.
#include "vtkAdaptiveLICMapperInternals.h"

#include "vtkImageData.h"
#include "vtkLICNoiseSource.h"
#include "vtkMath.h"

#include <algorithm>
#include <cmath>

// A setting; if it changes, so does `then`.
#define relevoSetThenMacro(name, type, condition, range, then)           \
  void vtkAdaptiveLICMapper::Set##name(type value)                       \
  {                                                                      \
    if (!(condition))                                                    \
    {                                                                    \
      vtkErrorMacro(#name " has to be " range ", not " << value << "."); \
    }                                                                    \
    else if (this->name != value)                                        \
    {                                                                    \
      this->name = value;                                                \
      then;                                                              \
    }                                                                    \
  }

// One for which noise is convolved again.
#define relevoSetMacro(name, type, condition, range) \
  relevoSetThenMacro(name, type, condition, range, this->LIC->SettingsTime.Modified())

#define relevoSetFlagMacro(name)                  \
  void vtkAdaptiveLICMapper::Set##name(int value) \
  {                                               \
    value = value != 0;                           \
    if (this->name != value)                      \
    {                                             \
      this->name = value;                         \
      this->LIC->SettingsTime.Modified();         \
    }                                             \
  }

#define relevoIsShare value >= 0.0 && value <= 1.0

#define relevoSetShareMacro(name) relevoSetMacro(name, double, relevoIsShare, "in [0, 1]")

// Shares of colours, which every picture mixes.
#define relevoSetColorShareMacro(name) \
  relevoSetThenMacro(name, double, relevoIsShare, "in [0, 1]", static_cast<void>(0))

relevoSetFlagMacro(Enable);
relevoSetFlagMacro(NormalizeVectors);
relevoSetFlagMacro(EnhancedLIC);
relevoSetFlagMacro(OrientedLIC);
relevoSetFlagMacro(MaskOnSurface);
relevoSetFlagMacro(GenerateNoiseTexture);

relevoSetMacro(NumberOfSteps, int, value >= 1 && value <= 10000, "in [1, 10000]");
relevoSetMacro(StepSize, double, value > 0.0 && std::isfinite(value), "above 0");
relevoSetMacro(Phase, double, std::isfinite(value), "finite");
relevoSetMacro(AntiAlias, int, value >= 0, "at least 0");
relevoSetMacro(MaskThreshold, double, !std::isnan(value), "a number");
relevoSetThenMacro(
  MapModeBias, double, value >= -1.0 && value <= 1.0, "in [-1, 1]", static_cast<void>(0));
relevoSetMacro(EnhanceContrast, int,
  value == ENHANCE_CONTRAST_OFF || value == ENHANCE_CONTRAST_LIC ||
    value == ENHANCE_CONTRAST_COLOR || value == ENHANCE_CONTRAST_BOTH,
  "ENHANCE_CONTRAST_OFF (0), _LIC (1), _COLOR (3) or _BOTH (4)");
relevoSetShareMacro(LowLICContrastEnhancementFactor);
relevoSetShareMacro(HighLICContrastEnhancementFactor);
relevoSetColorShareMacro(LowColorContrastEnhancementFactor);
relevoSetColorShareMacro(HighColorContrastEnhancementFactor);
relevoSetColorShareMacro(MaskIntensity);
relevoSetColorShareMacro(LICIntensity);

void vtkAdaptiveLICMapper::SetNoDataMagnitude(double magnitude)
{
  if (!(magnitude > 0.0))
  {
    vtkErrorMacro("NoDataMagnitude has to be above 0, not " << magnitude << ".");
  }
  else if (this->NoDataMagnitude != magnitude)
  {
    this->NoDataMagnitude = magnitude;
    this->Modified(); // the buffers are without no-data
  }
}

void vtkAdaptiveLICMapper::SetMaskColor(double red, double green, double blue)
{
  const double color[3] = { red, green, blue };
  if (!vtkMath::IsFinite(red) || !vtkMath::IsFinite(green) || !vtkMath::IsFinite(blue))
  {
    vtkErrorMacro("MaskColor has to be finite.");
    return;
  }
  for (int i = 0; i < 3; ++i)
  {
    this->MaskColor[i] = vtkMath::ClampValue(color[i], 0.0, 1.0);
  }
}

//------------------------------------------------------------------------------
// Two modes share a name

void vtkAdaptiveLICMapper::SetColorMode(const int& mode)
{
  if (mode != COLOR_MODE_BLEND && mode != COLOR_MODE_MAP)
  {
    vtkErrorMacro("ColorMode of a LIC has to be COLOR_MODE_BLEND (0) or COLOR_MODE_MAP (1), not "
      << mode << ". For scalars there is SetColorModeToDirectScalars() and its like.");
    return;
  }
  this->LICColorMode = mode;
}

//------------------------------------------------------------------------------
// Noise

void vtkAdaptiveLICMapper::SetNoiseDataSet(vtkImageData* image)
{
  if (this->LIC->Noise.Image != image)
  {
    this->LIC->Noise.Image = image;
    this->LIC->Noise.Modified();
  }
}

vtkImageData* vtkAdaptiveLICMapper::GetNoiseDataSet()
{
  return this->LIC->Noise.Image;
}

void vtkAdaptiveLICMapper::SetNoiseFileName(const char* name)
{
  const std::string fileName = name ? name : "";
  if (this->LIC->Noise.FileName != fileName)
  {
    this->LIC->Noise.FileName = fileName;
    this->LIC->Noise.Modified();
  }
}

const char* vtkAdaptiveLICMapper::GetNoiseFileName()
{
  const std::string& name = this->LIC->Noise.FileName;
  return name.empty() ? nullptr : name.c_str();
}

#define relevoNoiseMacro(name, type)               \
  void vtkAdaptiveLICMapper::Set##name(type value) \
  {                                                \
    this->LIC->Noise.Source->Set##name(value);     \
  }                                                \
  type vtkAdaptiveLICMapper::Get##name()           \
  {                                                \
    return this->LIC->Noise.Source->Get##name();   \
  }

relevoNoiseMacro(NoiseType, int);
relevoNoiseMacro(NoiseTextureSize, int);
relevoNoiseMacro(NoiseGrainSize, int);
relevoNoiseMacro(MinNoiseValue, double);
relevoNoiseMacro(MaxNoiseValue, double);
relevoNoiseMacro(NumberOfNoiseLevels, int);
relevoNoiseMacro(ImpulseNoiseProbability, double);
relevoNoiseMacro(ImpulseNoiseBackgroundValue, double);
relevoNoiseMacro(NoiseGeneratorSeed, int);

//------------------------------------------------------------------------------
// What the passes take

relevo::LICSettings vtkAdaptiveLICMapper::vtkInternals::GetSettings() const
{
  const vtkAdaptiveLICMapper* self = this->Root;
  relevo::LICSettings settings;
  settings.NoiseMean = this->Noise.GetMean();
  relevo::LICKernel& kernel = settings.Kernel;
  kernel.Steps = self->NumberOfSteps;
  // Vectors that are not normalised come as shares of the longest.
  kernel.StepSize =
    static_cast<float>(self->StepSize * (self->NormalizeVectors ? 1.0 : this->Longest));
  kernel.Normalized = self->NormalizeVectors != 0;
  kernel.Oriented = self->OrientedLIC != 0;
  kernel.Phase = relevo::licWrapPhase(self->Phase);
  settings.Enhanced = self->EnhancedLIC != 0;
  settings.Stretched =
    self->EnhanceContrast == ENHANCE_CONTRAST_LIC || self->EnhanceContrast == ENHANCE_CONTRAST_BOTH;
  settings.StretchFactors = relevo::vec2(static_cast<float>(self->LowLICContrastEnhancementFactor),
    static_cast<float>(self->HighLICContrastEnhancementFactor));
  settings.NumberOfSmoothings = self->AntiAlias;
  return settings;
}

relevo::LICColoring vtkAdaptiveLICMapper::vtkInternals::GetColoring() const
{
  const vtkAdaptiveLICMapper* self = this->Root;
  return { self->LICColorMode, self->LICIntensity, self->MapModeBias };
}

bool vtkAdaptiveLICMapper::vtkInternals::StretchesColors() const
{
  const int mode = this->Root->EnhanceContrast;
  return mode == ENHANCE_CONTRAST_COLOR || mode == ENHANCE_CONTRAST_BOTH;
}

//------------------------------------------------------------------------------

void vtkAdaptiveLICMapper::ShallowCopy(vtkAbstractMapper* mapper)
{
  this->Superclass::ShallowCopy(mapper);
  vtkAdaptiveLICMapper* other = vtkAdaptiveLICMapper::SafeDownCast(mapper);
  if (!other)
  {
    return;
  }
  this->SetInputArrayToProcess(0, other->GetInputArrayInformation(0));
  this->SetEnable(other->Enable);
  this->SetNumberOfSteps(other->NumberOfSteps);
  this->SetStepSize(other->StepSize);
  this->SetNormalizeVectors(other->NormalizeVectors);
  this->SetEnhancedLIC(other->EnhancedLIC);
  this->SetOrientedLIC(other->OrientedLIC);
  this->SetPhase(other->Phase);
  this->SetEnhanceContrast(other->EnhanceContrast);
  this->SetLowLICContrastEnhancementFactor(other->LowLICContrastEnhancementFactor);
  this->SetHighLICContrastEnhancementFactor(other->HighLICContrastEnhancementFactor);
  this->SetLowColorContrastEnhancementFactor(other->LowColorContrastEnhancementFactor);
  this->SetHighColorContrastEnhancementFactor(other->HighColorContrastEnhancementFactor);
  this->SetAntiAlias(other->AntiAlias);
  this->SetMaskThreshold(other->MaskThreshold);
  this->SetMaskOnSurface(other->MaskOnSurface);
  this->SetMaskIntensity(other->MaskIntensity);
  this->SetNoDataMagnitude(other->NoDataMagnitude);
  this->SetLICIntensity(other->LICIntensity);
  this->SetMapModeBias(other->MapModeBias);
  this->SetGenerateNoiseTexture(other->GenerateNoiseTexture);
  this->SetMaskColor(other->MaskColor);
  this->SetNoiseDataSet(other->GetNoiseDataSet());
  this->SetNoiseFileName(other->GetNoiseFileName());
  this->SetNoiseType(other->GetNoiseType());
  this->SetNoiseTextureSize(other->GetNoiseTextureSize());
  this->SetNoiseGrainSize(other->GetNoiseGrainSize());
  this->SetMinNoiseValue(other->GetMinNoiseValue());
  this->SetMaxNoiseValue(other->GetMaxNoiseValue());
  this->SetNumberOfNoiseLevels(other->GetNumberOfNoiseLevels());
  this->SetImpulseNoiseProbability(other->GetImpulseNoiseProbability());
  this->SetImpulseNoiseBackgroundValue(other->GetImpulseNoiseBackgroundValue());
  this->SetNoiseGeneratorSeed(other->GetNoiseGeneratorSeed());
  this->SetColorMode(other->LICColorMode);
}

void vtkAdaptiveLICMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Enable: " << this->Enable << "\n";
  os << indent << "NumberOfSteps: " << this->NumberOfSteps << "\n";
  os << indent << "StepSize: " << this->StepSize << "\n";
  os << indent << "NormalizeVectors: " << this->NormalizeVectors << "\n";
  os << indent << "EnhancedLIC: " << this->EnhancedLIC << "\n";
  os << indent << "OrientedLIC: " << this->OrientedLIC << "\n";
  os << indent << "Phase: " << this->Phase << "\n";
  os << indent << "EnhanceContrast: " << this->EnhanceContrast << "\n";
  os << indent << "AntiAlias: " << this->AntiAlias << "\n";
  os << indent << "MaskThreshold: " << this->MaskThreshold << "\n";
  os << indent << "MaskOnSurface: " << this->MaskOnSurface << "\n";
  os << indent << "MaskIntensity: " << this->MaskIntensity << "\n";
  os << indent << "NoDataMagnitude: " << this->NoDataMagnitude << "\n";
  os << indent << "LICColorMode: " << this->LICColorMode << "\n";
  os << indent << "LICIntensity: " << this->LICIntensity << "\n";
  os << indent << "MapModeBias: " << this->MapModeBias << "\n";
  os << indent << "GenerateNoiseTexture: " << this->GenerateNoiseTexture << "\n";
  os << indent << "NumberOfConvolutions: " << this->NumberOfConvolutions << "\n";
}
