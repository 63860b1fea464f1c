// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLICSettings.h"

#include "Checks/SettingChecks.h"
#include "Noise/NoiseRanges.h"
#include "vtkImageData.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace
{
constexpr int MaximumSteps = 100000;
constexpr int MaximumSmoothings = 1000;
}

vtkStandardNewMacro(vtkLICSettings);

vtkLICSettings::vtkLICSettings() = default;
vtkLICSettings::~vtkLICSettings() = default;

vtkObject* vtkLICSettings::GetErrorSource()
{
  return this->Holder ? this->Holder : this;
}

template <typename Value>
void vtkLICSettings::Set(Value& setting, Value value)
{
  if (setting != value)
  {
    setting = value;
    this->Modified();
  }
}

template <typename Value>
void vtkLICSettings::SetInRange(
  const char* name, Value& setting, Value value, Value lowest, Value highest)
{
  if (relevo::CheckRange(this->GetErrorSource(), name, value, lowest, highest))
  {
    this->Set(setting, value);
  }
}

void vtkLICSettings::SetShare(const char* name, double& share, double value)
{
  this->SetInRange(name, share, value, 0.0, 1.0);
}

void vtkLICSettings::SetFactor(const char* name, double& factor, double value)
{
  this->SetInRange(name, factor, value, -1.0, 1.0);
}

void vtkLICSettings::SetFlag(int& flag, int value)
{
  this->Set(flag, value != 0 ? 1 : 0);
}

vtkMTimeType vtkLICSettings::GetMTime()
{
  const vtkMTimeType time = this->Superclass::GetMTime();
  vtkImageData* noise = this->Values.NoiseDataSet;
  return noise ? std::max(time, noise->GetMTime()) : time;
}

void vtkLICSettings::ShallowCopy(vtkLICSettings* other)
{
  if (other && other != this)
  {
    this->Values = other->Values;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
// Streamlines

void vtkLICSettings::SetEnable(int enable)
{
  this->SetFlag(this->Values.Enable, enable);
}

void vtkLICSettings::SetNumberOfSteps(int steps)
{
  this->SetInRange("NumberOfSteps", this->Values.NumberOfSteps, steps, 1, MaximumSteps);
}

void vtkLICSettings::SetStepSize(double size)
{
  if (!(size > 0.0) || !std::isfinite(size))
  {
    vtkErrorWithObjectMacro(
      this->GetErrorSource(), << "StepSize must be more than 0 and finite, got " << size << ".");
    return;
  }
  this->Set(this->Values.StepSize, size);
}

void vtkLICSettings::SetNormalizeVectors(int normalize)
{
  this->SetFlag(this->Values.NormalizeVectors, normalize);
}

void vtkLICSettings::SetEnhancedLIC(int enhanced)
{
  this->SetFlag(this->Values.EnhancedLIC, enhanced);
}

void vtkLICSettings::SetOrientedLIC(int oriented)
{
  this->SetFlag(this->Values.OrientedLIC, oriented);
}

void vtkLICSettings::SetPhase(double phase)
{
  this->SetInRange(
    "Phase", this->Values.Phase, phase, -relevo::LargestDouble, relevo::LargestDouble);
}

void vtkLICSettings::SetAntiAlias(int passes)
{
  if (relevo::CheckRange(this->GetErrorSource(), "AntiAlias", passes, 0, VTK_INT_MAX))
  {
    this->SetInRange("AntiAlias", this->Values.AntiAlias, passes, 0, MaximumSmoothings);
  }
}

//------------------------------------------------------------------------------
// Contrast

void vtkLICSettings::SetEnhanceContrast(int mode)
{
  if (mode != ENHANCE_CONTRAST_OFF && mode != ENHANCE_CONTRAST_LIC &&
    mode != ENHANCE_CONTRAST_COLOR && mode != ENHANCE_CONTRAST_BOTH)
  {
    vtkErrorWithObjectMacro(this->GetErrorSource(),
      << "EnhanceContrast must be one of OFF (0), LIC (1), COLOR (3), BOTH (4), got " << mode
      << ".");
    return;
  }
  this->Set(this->Values.EnhanceContrast, mode);
}

bool vtkLICSettings::EnhancesLICContrast() const
{
  const int mode = this->Values.EnhanceContrast;
  return mode == ENHANCE_CONTRAST_LIC || mode == ENHANCE_CONTRAST_BOTH;
}

bool vtkLICSettings::EnhancesColorContrast() const
{
  const int mode = this->Values.EnhanceContrast;
  return mode == ENHANCE_CONTRAST_COLOR || mode == ENHANCE_CONTRAST_BOTH;
}

void vtkLICSettings::SetLowLICContrastEnhancementFactor(double factor)
{
  this->SetFactor("LowLICContrastEnhancementFactor", this->Values.LowLICContrast, factor);
}

double vtkLICSettings::GetLowLICContrastEnhancementFactor() const
{
  return this->Values.LowLICContrast;
}

void vtkLICSettings::SetHighLICContrastEnhancementFactor(double factor)
{
  this->SetFactor("HighLICContrastEnhancementFactor", this->Values.HighLICContrast, factor);
}

double vtkLICSettings::GetHighLICContrastEnhancementFactor() const
{
  return this->Values.HighLICContrast;
}

void vtkLICSettings::SetLowColorContrastEnhancementFactor(double factor)
{
  this->SetFactor("LowColorContrastEnhancementFactor", this->Values.LowColorContrast, factor);
}

double vtkLICSettings::GetLowColorContrastEnhancementFactor() const
{
  return this->Values.LowColorContrast;
}

void vtkLICSettings::SetHighColorContrastEnhancementFactor(double factor)
{
  this->SetFactor("HighColorContrastEnhancementFactor", this->Values.HighColorContrast, factor);
}

double vtkLICSettings::GetHighColorContrastEnhancementFactor() const
{
  return this->Values.HighColorContrast;
}

//------------------------------------------------------------------------------
// Mask

void vtkLICSettings::SetMaskThreshold(double threshold)
{
  if (std::isnan(threshold))
  {
    vtkErrorWithObjectMacro(this->GetErrorSource(), << "MaskThreshold must be a number, got NaN.");
    return;
  }
  this->Set(this->Values.MaskThreshold, threshold);
}

void vtkLICSettings::SetMaskOnSurface(int onSurface)
{
  this->SetFlag(this->Values.MaskOnSurface, onSurface);
}

void vtkLICSettings::SetMaskColor(double red, double green, double blue)
{
  const std::array<double, 3> color = { { red, green, blue } };
  double(&setting)[3] = this->Values.MaskColor;
  if (relevo::CheckVector(this->GetErrorSource(), "MaskColor", color, 0.0, 1.0) &&
    !std::equal(color.begin(), color.end(), setting))
  {
    std::copy(color.begin(), color.end(), setting);
    this->Modified();
  }
}

void vtkLICSettings::GetMaskColor(double color[3]) const
{
  std::copy(this->Values.MaskColor, this->Values.MaskColor + 3, color);
}

void vtkLICSettings::GetMaskColor(double& red, double& green, double& blue) const
{
  red = this->Values.MaskColor[0];
  green = this->Values.MaskColor[1];
  blue = this->Values.MaskColor[2];
}

void vtkLICSettings::SetMaskIntensity(double intensity)
{
  this->SetShare("MaskIntensity", this->Values.MaskIntensity, intensity);
}

void vtkLICSettings::SetNoDataMagnitude(double magnitude)
{
  if (!(magnitude > 0.0))
  {
    vtkErrorWithObjectMacro(
      this->GetErrorSource(), << "NoDataMagnitude must be more than 0, got " << magnitude << ".");
    return;
  }
  this->Set(this->Values.NoDataMagnitude, magnitude);
}

//------------------------------------------------------------------------------
// Colours

void vtkLICSettings::SetColorMode(int mode)
{
  if (relevo::CheckChoice(this->GetErrorSource(), "ColorMode", mode, { "BLEND", "MAP" }))
  {
    this->Set(this->Values.ColorMode, mode);
  }
}

void vtkLICSettings::SetLICIntensity(double intensity)
{
  this->SetShare("LICIntensity", this->Values.LICIntensity, intensity);
}

void vtkLICSettings::SetMapModeBias(double bias)
{
  this->SetFactor("MapModeBias", this->Values.MapModeBias, bias);
}

//------------------------------------------------------------------------------
// Noise

void vtkLICSettings::SetNoiseDataSet(vtkImageData* image)
{
  if (this->Values.NoiseDataSet != image)
  {
    this->Values.NoiseDataSet = image;
    this->Modified();
  }
}

vtkImageData* vtkLICSettings::GetNoiseDataSet() const
{
  return this->Values.NoiseDataSet;
}

void vtkLICSettings::SetNoiseFileName(const char* name)
{
  const std::string fileName = name ? name : "";
  if (this->Values.NoiseFileName != fileName)
  {
    this->Values.NoiseFileName = fileName;
    this->Modified();
  }
}

const char* vtkLICSettings::GetNoiseFileName() const
{
  const std::string& name = this->Values.NoiseFileName;
  return name.empty() ? nullptr : name.c_str();
}

void vtkLICSettings::SetGenerateNoiseTexture(int generate)
{
  this->SetFlag(this->Values.GenerateNoiseTexture, generate);
}

void vtkLICSettings::SetNoiseType(int type)
{
  if (relevo::CheckChoice(
        this->GetErrorSource(), "NoiseType", type, { "UNIFORM", "GAUSSIAN", "PERLIN" }))
  {
    this->Set(this->Values.NoiseType, type);
  }
}

void vtkLICSettings::SetNoiseTextureSize(int length)
{
  this->SetInRange("NoiseTextureSize", this->Values.NoiseTextureSize, length,
    relevo::SmallestNoiseTexture, relevo::LargestNoiseTexture);
}

void vtkLICSettings::SetNoiseGrainSize(int length)
{
  this->SetInRange(
    "NoiseGrainSize", this->Values.NoiseGrainSize, length, 1, relevo::LargestNoiseTexture - 1);
}

void vtkLICSettings::SetMinNoiseValue(double value)
{
  this->SetShare("MinNoiseValue", this->Values.MinNoiseValue, value);
}

void vtkLICSettings::SetMaxNoiseValue(double value)
{
  this->SetShare("MaxNoiseValue", this->Values.MaxNoiseValue, value);
}

void vtkLICSettings::SetNumberOfNoiseLevels(int levels)
{
  this->SetInRange("NumberOfNoiseLevels", this->Values.NumberOfNoiseLevels, levels,
    relevo::FewestNoiseLevels, VTK_INT_MAX);
}

void vtkLICSettings::SetImpulseNoiseProbability(double probability)
{
  this->SetShare("ImpulseNoiseProbability", this->Values.ImpulseNoiseProbability, probability);
}

void vtkLICSettings::SetImpulseNoiseBackgroundValue(double value)
{
  this->SetShare("ImpulseNoiseBackgroundValue", this->Values.ImpulseNoiseBackground, value);
}

void vtkLICSettings::SetNoiseGeneratorSeed(int seed)
{
  this->Set(this->Values.NoiseGeneratorSeed, seed);
}

void vtkLICSettings::SetCompositeStrategy(int strategy)
{
  if (relevo::CheckChoice(this->GetErrorSource(), "CompositeStrategy", strategy,
        { "INPLACE", "INPLACE_DISJOINT", "BALANCED", "AUTO" }))
  {
    this->Set(this->Values.CompositeStrategy, strategy);
  }
}

//------------------------------------------------------------------------------

void vtkLICSettings::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const SettingValues& values = this->Values;
  const auto print = [&](const char* name, auto value)
  { os << indent << name << ": " << value << "\n"; };
  print("Enable", values.Enable);
  print("NumberOfSteps", values.NumberOfSteps);
  print("StepSize", values.StepSize);
  print("NormalizeVectors", values.NormalizeVectors);
  print("EnhancedLIC", values.EnhancedLIC);
  print("OrientedLIC", values.OrientedLIC);
  print("Phase", values.Phase);
  print("EnhanceContrast", values.EnhanceContrast);
  print("LowLICContrastEnhancementFactor", values.LowLICContrast);
  print("HighLICContrastEnhancementFactor", values.HighLICContrast);
  print("LowColorContrastEnhancementFactor", values.LowColorContrast);
  print("HighColorContrastEnhancementFactor", values.HighColorContrast);
  print("AntiAlias", values.AntiAlias);
  print("MaskThreshold", values.MaskThreshold);
  print("MaskOnSurface", values.MaskOnSurface);
  os << indent << "MaskColor: " << values.MaskColor[0] << " " << values.MaskColor[1] << " "
     << values.MaskColor[2] << "\n";
  print("MaskIntensity", values.MaskIntensity);
  print("NoDataMagnitude", values.NoDataMagnitude);
  print("ColorMode", values.ColorMode);
  print("LICIntensity", values.LICIntensity);
  print("MapModeBias", values.MapModeBias);
  print("NoiseDataSet", values.NoiseDataSet.Get());
  print("NoiseFileName", values.NoiseFileName.empty() ? "(none)" : values.NoiseFileName.c_str());
  print("GenerateNoiseTexture", values.GenerateNoiseTexture);
  print("NoiseType", values.NoiseType);
  print("NoiseTextureSize", values.NoiseTextureSize);
  print("NoiseGrainSize", values.NoiseGrainSize);
  print("MinNoiseValue", values.MinNoiseValue);
  print("MaxNoiseValue", values.MaxNoiseValue);
  print("NumberOfNoiseLevels", values.NumberOfNoiseLevels);
  print("ImpulseNoiseProbability", values.ImpulseNoiseProbability);
  print("ImpulseNoiseBackgroundValue", values.ImpulseNoiseBackground);
  print("NoiseGeneratorSeed", values.NoiseGeneratorSeed);
  print("CompositeStrategy", values.CompositeStrategy);
}
