// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkLineIntegralConvolution promises: input and settings that it cannot use give an error that
// names the cause, and an empty output. After a correction the filter runs again.
#include "RelevoBlocks.h"
#include "RelevoCheck.h"
#include "RelevoFlowImages.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkExecutive.h"
#include "vtkFloatArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

#include <limits>

namespace
{
using Change = std::function<void(vtkLineIntegralConvolution*)>;

vtkSmartPointer<vtkImageData> MakeImage()
{
  return MakeFlowImage(8, 6, MakeUniformField(1.0, 2.0));
}

bool Fails(vtkLineIntegralConvolution* filter, const std::string& words)
{
  RelevoErrors errors(filter);
  RelevoErrors executiveErrors(filter->GetExecutive());
  filter->Update();
  const bool empty = filter->GetOutput()->GetNumberOfPoints() == 0 &&
    filter->GetOutput()->GetPointData()->GetNumberOfArrays() == 0;
  return errors.Said(words) && empty;
}

// A value out of range is reported at once and changes nothing.
void TestSetting(RelevoCheck& check, const Change& spoil, const Change& mend, const char* words)
{
  vtkNew<vtkLineIntegralConvolution> filter;
  filter->SetInputData(MakeImage());
  const auto before = RunLIC(filter);
  const vtkMTimeType time = filter->GetMTime();
  CHECK(!before.empty());
  {
    RelevoErrors errors(filter);
    spoil(filter);
    CHECK(errors.Said(words));
  }
  CHECK_EQUAL(filter->GetMTime(), time);
  filter->Modified();
  CHECK_EQUAL(RunLIC(filter), before);
  RelevoErrors errors(filter);
  mend(filter);
  CHECK(!RunLIC(filter).empty());
  CHECK(errors.None());
}

// Each value is in range, but the combination is invalid.
void TestSettingsTogether(
  RelevoCheck& check, const Change& spoil, const Change& mend, const char* words)
{
  vtkNew<vtkLineIntegralConvolution> filter;
  filter->SetInputData(MakeImage());
  CHECK(!RunLIC(filter).empty());
  spoil(filter);
  CHECK(Fails(filter, words));
  mend(filter);
  CHECK(!RunLIC(filter).empty());
}

void TestSettings(RelevoCheck& check)
{
  using Filter = vtkLineIntegralConvolution;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  for (int steps : { 0, -3, 100001 })
  {
    TestSetting(
      check, [=](Filter* f) { f->SetNumberOfSteps(steps); },
      [](Filter* f) { f->SetNumberOfSteps(1); }, "NumberOfSteps");
  }
  for (double size : { 0.0, -1.0, nan, infinity })
  {
    TestSetting(
      check, [=](Filter* f) { f->SetStepSize(size); }, [](Filter* f) { f->SetStepSize(0.5); },
      "StepSize");
  }
  for (int contrast : { -1, 2, 3, 4 })
  {
    TestSetting(
      check, [=](Filter* f) { f->SetEnhanceContrast(contrast); },
      [](Filter* f) { f->SetEnhanceContrast(1); },
      "EnhanceContrast must be one of OFF (0), LIC (1)");
  }
  TestSettingsTogether(
    check, [](Filter* f) { f->SetLowLICContrastEnhancementFactor(1.0); },
    [](Filter* f) { f->SetLowLICContrastEnhancementFactor(0.5); },
    "LowLICContrastEnhancementFactor");
  TestSettingsTogether(
    check, [](Filter* f) { f->SetHighLICContrastEnhancementFactor(1.0); },
    [](Filter* f) { f->SetHighLICContrastEnhancementFactor(0.0); },
    "HighLICContrastEnhancementFactor");
  for (double factor : { -1.1, 1.1, 2.0, nan, infinity })
  {
    TestSetting(
      check, [=](Filter* f) { f->SetLowLICContrastEnhancementFactor(factor); },
      [](Filter* f) { f->SetLowLICContrastEnhancementFactor(0.5); },
      "LowLICContrastEnhancementFactor");
    TestSetting(
      check, [=](Filter* f) { f->SetHighLICContrastEnhancementFactor(factor); },
      [](Filter* f) { f->SetHighLICContrastEnhancementFactor(-1.0); },
      "HighLICContrastEnhancementFactor");
  }
  TestSetting(
    check, [](Filter* f) { f->SetAntiAlias(-1); }, [](Filter* f) { f->SetAntiAlias(0); },
    "AntiAlias must be at least 0, got -1");
  TestSetting(
    check, [=](Filter* f) { f->SetMaskThreshold(nan); }, [](Filter* f) { f->SetMaskThreshold(0); },
    "MaskThreshold");
  for (double magnitude : { 0.0, -5.0, nan })
  {
    TestSetting(
      check, [=](Filter* f) { f->SetNoDataMagnitude(magnitude); },
      [=](Filter* f) { f->SetNoDataMagnitude(infinity); }, "NoDataMagnitude");
  }
  for (double phase : { nan, infinity })
  {
    TestSetting(
      check, [=](Filter* f) { f->SetPhase(phase); }, [](Filter* f) { f->SetPhase(-7.25); },
      "Phase");
  }
}

void TestInput(RelevoCheck& check, vtkImageData* image, const char* words)
{
  vtkNew<vtkLineIntegralConvolution> filter;
  filter->SetInputData(image);
  CHECK(Fails(filter, words));
  filter->SetInputData(MakeImage());
  CHECK(!RunLIC(filter).empty());
}

void TestInputs(RelevoCheck& check)
{
  vtkNew<vtkImageData> empty;
  TestInput(check, empty, "is empty");
  vtkNew<vtkImageData> bare;
  bare->SetDimensions(4, 4, 1);
  TestInput(check, bare, "no point array of 2 or 3 components");
  TestInput(check, MakeNoiseImage(4, 4), "no point array of 2 or 3 components");
  vtkNew<vtkImageData> volume;
  volume->SetDimensions(3, 4, 5);
  volume->AllocateScalars(VTK_FLOAT, 3);
  TestInput(check, volume, "3 x 4 x 5");
  for (double spacing : { 0.0, std::numeric_limits<double>::quiet_NaN() })
  {
    CHECK_CASE(spacing);
    const auto image = MakeImage();
    image->SetSpacing(1.0, spacing, 1.0);
    TestInput(check, image, "spacing");
  }
}

void TestArrays(RelevoCheck& check)
{
  const auto image = MakeImage();
  const auto cells = MakeFlowImage(7, 5, MakeUniformField(1.0, 0.0));
  cells->GetPointData()->GetArray(0)->SetName("OfCells");
  image->GetCellData()->AddArray(cells->GetPointData()->GetArray(0));
  const auto noise = MakeNoiseImage(8, 6);
  vtkDataArray* scalars = noise->GetPointData()->GetScalars();
  scalars->SetName("Scalars");
  image->GetPointData()->AddArray(scalars);
  vtkNew<vtkStringArray> text;
  text->SetName("Text");
  text->SetNumberOfValues(48);
  image->GetPointData()->AddArray(text);
  vtkNew<vtkFloatArray> shorter;
  shorter->SetName("Short");
  shorter->SetNumberOfComponents(2);
  shorter->SetNumberOfTuples(47);
  shorter->Fill(1.0);
  image->GetPointData()->AddArray(shorter);
  vtkNew<vtkFloatArray> tensors;
  tensors->SetName("Tensors");
  tensors->SetNumberOfComponents(9);
  tensors->SetNumberOfTuples(48);
  tensors->Fill(1.0);
  image->GetPointData()->AddArray(tensors);

  const auto named = [&](int association, const char* name, const char* words)
  {
    vtkNew<vtkLineIntegralConvolution> filter;
    filter->SetInputData(image);
    filter->SetInputArrayToProcess(0, 0, 0, association, name);
    CHECK(Fails(filter, words));
    filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Flow");
    CHECK(!RunLIC(filter).empty());
  };
  named(vtkDataObject::FIELD_ASSOCIATION_POINTS, "Nowhere", "no point array \"Nowhere\"");
  named(vtkDataObject::FIELD_ASSOCIATION_POINTS, "OfCells",
    "has no point array \"OfCells\", but a cell array of that name. Convert it with "
    "vtkCellDataToPointData.");
  named(vtkDataObject::FIELD_ASSOCIATION_CELLS, "OfCells", "vtkCellDataToPointData");
  named(vtkDataObject::FIELD_ASSOCIATION_POINTS, "Text", "no point array \"Text\"");
  named(vtkDataObject::FIELD_ASSOCIATION_POINTS, "Scalars", "48 tuples of 1");
  named(vtkDataObject::FIELD_ASSOCIATION_POINTS, "Tensors", "48 tuples of 9");
  named(vtkDataObject::FIELD_ASSOCIATION_POINTS, "Short", "47 tuples of 2");
}

void TestNoise(RelevoCheck& check)
{
  vtkNew<vtkImageData> bare;
  bare->SetDimensions(4, 4, 1);
  vtkNew<vtkImageData> volume;
  volume->SetDimensions(2, 2, 2);
  volume->AllocateScalars(VTK_FLOAT, 1);
  volume->GetPointData()->GetScalars()->Fill(0.5);
  const auto makeSpoilt = [](double value)
  {
    const auto noise = MakeNoiseImage(4, 4);
    noise->GetPointData()->GetScalars()->SetComponent(6, 0, value);
    return noise;
  };
  const std::pair<vtkSmartPointer<vtkImageData>, std::string> cases[] = {
    { vtkSmartPointer<vtkImageData>::New(), "noise is empty" },
    { bare.Get(), "noise has no point scalars" }, { volume.Get(), "2 x 2 x 2" },
    { makeSpoilt(1.5), "1.5 outside [0, 1] at point 6" }, { makeSpoilt(-0.1), "outside [0, 1]" },
    { makeSpoilt(std::numeric_limits<double>::quiet_NaN()), "outside [0, 1]" }
  };
  for (const auto& noise : cases)
  {
    vtkNew<vtkLineIntegralConvolution> filter;
    filter->SetInputData(MakeImage());
    filter->SetNoiseData(noise.first);
    CHECK(Fails(filter, noise.second));
    filter->SetNoiseData(nullptr);
    CHECK(!RunLIC(filter).empty());
  }
}

void TestBlocks(RelevoCheck& check)
{
  vtkNew<vtkLineIntegralConvolution> filter;
  CHECK(RelevoRefusesBlock(
    filter, 0, vtkNew<vtkPolyData>(), "The input is a vtkPolyData; a vtkImageData is needed."));
  filter->SetInputData(MakeImage());
  CHECK(RelevoRefusesBlock(filter, 1, vtkNew<vtkPolyData>(),
    "The input of port 1 is a vtkPolyData; a vtkImageData is needed."));
}
}

int TestLineIntegralConvolutionErrors(int, char*[])
{
  RelevoCheck check;
  TestSettings(check);
  TestInputs(check);
  TestArrays(check);
  TestNoise(check);
  TestBlocks(check);
  return check.GetResult();
}
