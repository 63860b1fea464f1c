// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkLICSettings promises: values out of range are errors that change nothing, and several mappers
// and filters can share one object.
#include "RelevoCheck.h"
#include "RelevoFlowImages.h"
#include "RelevoSurfaceLIC.h"
#include "RelevoTestMeshes.h"

#include "vtkExecutive.h"
#include "vtkImageData.h"
#include "vtkLICSettings.h"

#include <array>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace
{
const double NaN = std::numeric_limits<double>::quiet_NaN();
const double Infinity = std::numeric_limits<double>::infinity();

struct Setting
{
  const char* Name;
  std::function<void(vtkLICSettings*, double)> Set;
  std::function<double(vtkLICSettings*)> Get;
  double Default;
  std::vector<double> Good;
  std::vector<double> Bad;
};

#define relevoSettingMacro(name, type)                                                     \
#name, [](vtkLICSettings * s, double value) { s->Set##name(static_cast<type>(value)); }, \
    [](vtkLICSettings * s) { return static_cast<double>(s->Get##name()); }

std::vector<Setting> MakeSettings()
{
  const std::vector<double> share = { 0.0, 1.0, 0.25 };
  const std::vector<double> noShare = { -0.01, 1.01, NaN, Infinity, -Infinity };
  const std::vector<double> factor = { -1.0, 1.0, -0.25 };
  const std::vector<double> noFactor = { -1.01, 1.01, NaN, Infinity, -Infinity };
  return {
    { relevoSettingMacro(Enable, int), 1, { 0, 1 }, {} },
    { relevoSettingMacro(NumberOfSteps, int), 20, { 1, 40, 100000 }, { 0, -3, 100001 } },
    { relevoSettingMacro(StepSize, double), 1, { 0.25, 1e9 }, { 0, -1, NaN, Infinity } },
    { relevoSettingMacro(NormalizeVectors, int), 1, { 0, 1 }, {} },
    { relevoSettingMacro(EnhancedLIC, int), 1, { 0, 1 }, {} },
    { relevoSettingMacro(OrientedLIC, int), 0, { 1, 0 }, {} },
    { relevoSettingMacro(Phase, double), 0, { -7.25, 0.5 }, { NaN, Infinity } },
    { relevoSettingMacro(EnhanceContrast, int), 0, { 1, 3, 4, 0 }, { -1, 2, 5 } },
    { relevoSettingMacro(LowLICContrastEnhancementFactor, double), 0, factor, noFactor },
    { relevoSettingMacro(HighLICContrastEnhancementFactor, double), 0, factor, noFactor },
    { relevoSettingMacro(LowColorContrastEnhancementFactor, double), 0, factor, noFactor },
    { relevoSettingMacro(HighColorContrastEnhancementFactor, double), 0, factor, noFactor },
    { relevoSettingMacro(AntiAlias, int), 0, { 2, 1000, 0 }, { -1, 1001 } },
    { relevoSettingMacro(MaskThreshold, double), 0, { -1, 0.5, Infinity }, { NaN } },
    { relevoSettingMacro(MaskOnSurface, int), 0, { 1, 0 }, {} },
    { relevoSettingMacro(MaskIntensity, double), 0, share, noShare },
    { relevoSettingMacro(NoDataMagnitude, double), 1e8, { 1e-3, Infinity }, { 0, -5, NaN } },
    { relevoSettingMacro(ColorMode, int), 0, { 1, 0 }, { -1, 2 } },
    { relevoSettingMacro(LICIntensity, double), 0.8, share, noShare },
    { relevoSettingMacro(MapModeBias, double), 0, { -1, 1, 0.3 }, { -1.01, 1.01, NaN } },
    { relevoSettingMacro(GenerateNoiseTexture, int), 1, { 0, 1 }, {} },
    { relevoSettingMacro(NoiseType, int), 1, { 0, 2, 1 }, { -1, 3 } },
    { relevoSettingMacro(NoiseTextureSize, int), 200, { 2, 16384 }, { 1, 0, -7, 16385 } },
    { relevoSettingMacro(NoiseGrainSize, int), 1, { 3, 16383 }, { 0, -1, 16384 } },
    { relevoSettingMacro(MinNoiseValue, double), 0, share, noShare },
    { relevoSettingMacro(MaxNoiseValue, double), 0.8, share, noShare },
    { relevoSettingMacro(NumberOfNoiseLevels, int), 256, { 2, 1024 }, { 1, 0, -2 } },
    { relevoSettingMacro(ImpulseNoiseProbability, double), 1, share, noShare },
    { relevoSettingMacro(ImpulseNoiseBackgroundValue, double), 0, share, noShare },
    { relevoSettingMacro(NoiseGeneratorSeed, int), 1, { -5, 0, 7 }, {} },
    { relevoSettingMacro(CompositeStrategy, int), 3, { 0, 1, 2, 3 }, { -1, 4 } },
  };
}

void TestRanges(RelevoCheck& check)
{
  vtkNew<vtkLICSettings> settings;
  RelevoErrors errors(settings);
  for (const Setting& setting : MakeSettings())
  {
    CHECK_CASE(setting.Name);
    CHECK_EQUAL(setting.Get(settings), setting.Default);
    for (double value : setting.Good)
    {
      CHECK_CASE(value);
      const bool other = setting.Get(settings) != value;
      const vtkMTimeType before = settings->GetMTime();
      setting.Set(settings, value);
      CHECK(errors.None());
      CHECK_EQUAL(setting.Get(settings), value);
      CHECK_EQUAL(settings->GetMTime() > before, other);
      const vtkMTimeType after = settings->GetMTime();
      setting.Set(settings, value);
      CHECK_EQUAL(settings->GetMTime(), after);
    }
    const vtkMTimeType time = settings->GetMTime();
    for (double value : setting.Bad)
    {
      CHECK_CASE(value);
      setting.Set(settings, value);
      CHECK(errors.Said(std::string(setting.Name) + " must be "));
      CHECK_EQUAL(setting.Get(settings), setting.Good.back());
      CHECK_EQUAL(settings->GetMTime(), time);
    }
  }
  settings->SetEnable(0);
  settings->SetEnable(-7); // every number except 0 turns it on
  CHECK_EQUAL(settings->GetEnable(), 1);

  settings->SetMaskColor(0.1, 0.2, 1.0);
  for (const auto& color :
    { std::array<double, 3>{ { 0.5, -0.1, 0.5 } }, { { NaN, 0.5, 0.5 } }, { { 0.5, 0.5, 2.0 } } })
  {
    settings->SetMaskColor(color.data());
    CHECK(errors.Said("Each component of MaskColor must be in [0, 1], got ("));
  }
  double red;
  double green;
  double blue;
  settings->GetMaskColor(red, green, blue);
  CHECK_EQUAL(red, 0.1);
  CHECK_EQUAL(green, 0.2);
  CHECK_EQUAL(blue, 1.0);

  vtkNew<vtkLICSettings> copy;
  copy->ShallowCopy(settings);
  for (const Setting& setting : MakeSettings())
  {
    CHECK_CASE(setting.Name);
    CHECK_EQUAL(setting.Get(copy), setting.Get(settings));
  }
  CHECK_EQUAL(copy->GetMaskColor()[1], 0.2);
}

void TestNoiseChoice(RelevoCheck& check)
{
  vtkNew<vtkLICSettings> settings;
  CHECK(!settings->GetNoiseDataSet() && !settings->GetNoiseFileName());
  settings->SetNoiseFileName("noise.png");
  CHECK_EQUAL(std::string(settings->GetNoiseFileName()), "noise.png");
  const auto image = MakeNoiseImage(4, 4);
  settings->SetNoiseDataSet(image);
  const vtkMTimeType time = settings->GetMTime();
  image->Modified();
  CHECK_GREATER(settings->GetMTime(), time);
  vtkNew<vtkLICSettings> copy;
  copy->ShallowCopy(settings);
  CHECK_EQUAL(copy->GetNoiseDataSet(), image.Get());
  CHECK_EQUAL(std::string(copy->GetNoiseFileName()), "noise.png");
}

vtkSmartPointer<vtkImageData> MakeImage()
{
  return MakeFlowImage(30, 20, MakeUniformField(1.0, 2.0));
}

// The filter's setters and a shared settings object give the same images.
void TestImages(RelevoCheck& check)
{
  vtkNew<vtkLineIntegralConvolution> a;
  vtkNew<vtkLineIntegralConvolution> b;
  a->SetInputData(MakeImage());
  b->SetInputData(MakeImage());
  CHECK(a->GetLICSettings() && a->GetLICSettings() != b->GetLICSettings());
  const auto before = RunLIC(a);
  a->SetNumberOfSteps(7);
  a->SetPhase(0.25);
  a->SetAntiAlias(1);
  a->EnhancedLICOff();
  a->SetEnhanceContrastToLIC();
  vtkLICSettings* settings = b->GetLICSettings();
  settings->SetNumberOfSteps(7);
  settings->SetPhase(0.25);
  settings->SetAntiAlias(1);
  settings->EnhancedLICOff();
  settings->SetEnhanceContrastToBoth(); // an image has no colours to enhance
  CHECK(a->GetLICSettings()->GetNumberOfSteps() == 7 && b->GetNumberOfSteps() == 7);
  const auto after = RunLIC(a);
  CHECK(after != before && RunLIC(b) == after);

  a->SetLICSettings(settings);
  CHECK_EQUAL(a->GetLICSettings(), settings);
  const vtkMTimeType times[2] = { a->GetMTime(), b->GetMTime() };
  settings->SetNumberOfSteps(3);
  CHECK(a->GetMTime() > times[0] && b->GetMTime() > times[1]);
  const auto shorter = RunLIC(a);
  CHECK(shorter != after && RunLIC(b) == shorter);

  // Errors come from the object whose setter was called.
  RelevoErrors ofFilter(a);
  RelevoErrors ofSettings(settings);
  a->SetNumberOfSteps(0);
  CHECK(ofFilter.Said("NumberOfSteps must be in [1, 100000], got 0.") && ofSettings.None());
  settings->SetNumberOfSteps(0);
  CHECK(ofSettings.Said("NumberOfSteps") && ofFilter.None());
  a->SetEnhanceContrast(vtkLICSettings::ENHANCE_CONTRAST_COLOR);
  CHECK(
    ofFilter.Said("EnhanceContrast must be one of OFF (0), LIC (1), got 3.") && ofSettings.None());

  a->SetLICSettings(nullptr);
  CHECK(a->GetLICSettings() != settings && a->GetNumberOfSteps() == 20);
  CHECK_EQUAL(RunLIC(a), before);
}

// Other numbers in the settings' noise image can replace the second input.
void TestNoise(RelevoCheck& check)
{
  vtkNew<vtkLineIntegralConvolution> filter;
  filter->SetInputData(MakeImage());
  const auto before = RunLIC(filter);
  const auto noise = MakeNoiseImage(8, 9);
  filter->SetNoiseData(noise);
  const auto expected = RunLIC(filter);
  filter->SetNoiseData(nullptr);
  filter->GetLICSettings()->SetNoiseDataSet(noise);
  CHECK(expected != before && RunLIC(filter) == expected);
  filter->GetLICSettings()->SetNoiseDataSet(nullptr);
  CHECK_EQUAL(RunLIC(filter), before);
  filter->GetLICSettings()->SetNoiseGeneratorSeed(2);
  CHECK_NOT_EQUAL(RunLIC(filter), before);
  // Noise is then generated with default settings.
  filter->GetLICSettings()->GenerateNoiseTextureOff();
  CHECK_EQUAL(RunLIC(filter), before);
  filter->GetLICSettings()->GenerateNoiseTextureOn();

  RelevoErrors errors(filter);
  RelevoErrors ofExecutive(filter->GetExecutive());
  filter->GetLICSettings()->SetNoiseGrainSize(300);
  CHECK(RunLIC(filter).empty() && errors.Said("Cannot generate the noise"));
  filter->GetLICSettings()->SetNoiseFileName("/there/is/no/such/file.png");
  CHECK(RunLIC(filter).empty() && errors.Said("/there/is/no/such/file.png\" cannot be opened"));
}

void TestSurfaces(RelevoCheck& check)
{
  RelevoMeshes::Mesh mesh = RelevoMeshes::Plane(12, 12);
  AddVelocity(mesh,
    [](const RelevoVectors::Vector& p) {
      return RelevoVectors::Vector{ { -p[1], p[0] + 0.1, 0.0 } };
    });
  vtkNew<vtkSurfaceLineIntegralConvolution> a;
  a->SetGrainSize(0.125);
  const auto before = RelevoSurfaceLIC(a, mesh).Values;

  // One step of the settings is one grain of the noise.
  a->SetStepSize(0.0625);
  const auto half = RelevoSurfaceLIC(a, mesh).Values;
  a->SetStepSize(0.0);
  CHECK(half != before && RelevoSurfaceLIC(a, mesh).Values == before);
  a->GetLICSettings()->SetStepSize(0.5);
  CHECK_EQUAL(RelevoSurfaceLIC(a, mesh).Values, half);

  // A filter for images shares the same settings.
  vtkNew<vtkLineIntegralConvolution> b;
  b->SetInputData(MakeImage());
  b->SetLICSettings(a->GetLICSettings());
  const auto image = RunLIC(b);
  b->SetNumberOfSteps(5);
  b->OrientedLICOn();
  CHECK(a->GetNumberOfSteps() == 5 && a->GetOrientedLIC());
  CHECK(RunLIC(b) != image && RelevoSurfaceLIC(a, mesh).Values != half);
  RelevoErrors errors(a);
  a->SetNumberOfSteps(100001);
  CHECK(
    errors.Said("NumberOfSteps must be in [1, 100000], got 100001.") && b->GetNumberOfSteps() == 5);
  a->SetStepSize(-1.0);
  CHECK(errors.Said("StepSize must be at least 0 and finite, got -1.") && a->GetStepSize() == 0.0);
  a->SetTextureSize(0, 5);
  CHECK(errors.Said("TextureSize must be 0 x 0 or from 1 x 1 to 16384 x 16384, got 0 x 5.") &&
    a->GetTextureSize()[1] == 0);
}
}

int TestLICSettings(int, char*[])
{
  RelevoCheck check;
  TestRanges(check);
  TestNoiseChoice(check);
  TestImages(check);
  TestNoise(check);
  TestSurfaces(check);
  return check.GetResult();
}
