// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkLineIntegralConvolution promises: zero, short and missing vectors are masked, and the values
// stored there affect no other pixel.
#include "RelevoCheck.h"
#include "RelevoFlowImages.h"

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <iostream>
#include <limits>

namespace
{
constexpr int Columns = 90;
constexpr int Rows = 70;

bool IsInBlock(double x, double y)
{
  return x > 30.0 && x < 47.0 && y > 20.0 && y < 50.0;
}

vtkSmartPointer<vtkImageData> MakeImage(double first, double second)
{
  return MakeFlowImage(Columns, Rows,
    [=](double x, double y, double* v)
    {
      v[0] = IsInBlock(x, y) ? first : 20.0 - y;
      v[1] = IsInBlock(x, y) ? second : x - 25.0;
    });
}

// Whether exactly the block is masked and shows the noise unchanged.
bool IsMaskedInBlock(vtkImageData* lic, const std::vector<double>& noise)
{
  const std::vector<double> values = ValuesOf(lic, "LIC");
  const std::vector<double> mask = ValuesOf(lic, "LICMask");
  bool so = mask.size() == noise.size() && values.size() == noise.size();
  for (std::size_t i = 0; so && i < mask.size(); ++i)
  {
    const bool inBlock = IsInBlock(i % Columns + 0.5, i / Columns + 0.5);
    so = mask[i] == (inBlock ? 1.0 : 0.0) && (!inBlock || values[i] == noise[i]) &&
      values[i] >= 0.0 && values[i] <= 1.0;
  }
  return so;
}

void TestNoData(RelevoCheck& check)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  const double contents[][2] = { { 0.0, 0.0 }, { nan, nan }, { nan, 1.0 }, { 1.0, nan },
    { -1e9, -1e9 }, { 1e20, 1.0 }, { infinity, -infinity }, { 1e8, 0.0 }, { -1e8, 5.0 },
    { 3e38, 3e38 } };
  const auto noise = MakeNoiseImage(Columns, Rows);
  for (bool rich : { false, true })
  {
    CHECK_CASE(rich);
    std::vector<double> first;
    for (const double* content : contents)
    {
      vtkNew<vtkLineIntegralConvolution> filter;
      filter->SetInputData(MakeImage(content[0], content[1]));
      filter->SetNoiseData(noise);
      filter->SetEnhancedLIC(rich);
      filter->SetAntiAlias(rich ? 2 : 0);
      filter->SetEnhanceContrast(rich ? 1 : 0);
      const std::vector<double> lic = RunLIC(filter);
      CHECK(IsMaskedInBlock(filter->GetOutput(), ValuesOf(noise)));
      first = first.empty() ? lic : first;
      if (!CHECK_EQUAL(lic, first))
      {
        std::cerr << "  for " << content[0] << ", " << content[1] << "\n";
      }
    }
  }

  // The noise under the mask has no effect either.
  vtkNew<vtkImageData> other;
  other->DeepCopy(noise);
  vtkDataArray* scalars = other->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < other->GetNumberOfPoints(); ++i)
  {
    scalars->SetComponent(
      i, 0, IsInBlock(i % Columns + 0.5, i / Columns + 0.5) ? 1.0 : scalars->GetComponent(i, 0));
  }
  vtkNew<vtkLineIntegralConvolution> filter;
  filter->SetInputData(MakeImage(nan, nan));
  filter->SetNoiseData(noise);
  const std::vector<double> before = RunLIC(filter);
  filter->SetNoiseData(other);
  const std::vector<double> after = RunLIC(filter);
  const std::vector<double> mask = ValuesOf(filter->GetOutput(), "LICMask");
  bool same = true;
  for (std::size_t i = 0; i < mask.size(); ++i)
  {
    same = same && (mask[i] == 1.0 ? after[i] == 1.0 : after[i] == before[i]);
  }
  CHECK(same);
}

// Lines end at the border of the mask. Pixels there average fewer samples, and both sides behave
// alike.
void TestEnds(RelevoCheck& check)
{
  constexpr int Length = 40;
  constexpr int Hole = 25;
  const auto noise = MakeNoiseImage(Length, 1);
  const std::vector<double> values = ValuesOf(noise);
  for (double sign : { 1.0, -1.0 })
  {
    CHECK_CASE(sign);
    vtkNew<vtkLineIntegralConvolution> filter;
    filter->SetInputData(MakeFlowImage(Length, 1,
      [=](double x, double, double* v) { v[0] = static_cast<int>(x) == Hole ? -1e9 : sign; }));
    filter->SetNoiseData(noise);
    filter->EnhancedLICOff();
    filter->SetNumberOfSteps(6);
    const std::vector<double> lic = RunLIC(filter);
    for (int i = 0; i < Length && CHECK_EQUAL(lic.size(), Length); ++i)
    {
      const int begin = i == Hole ? Hole : std::max(i - 6, i > Hole ? Hole + 1 : 0);
      const int end = i == Hole ? Hole : std::min(i + 6, i < Hole ? Hole - 1 : Length - 1);
      double sum = 0.0;
      for (int k = begin; k <= end; ++k)
      {
        sum += values[k];
      }
      CHECK_NEAR(lic[i], sum / (end - begin + 1), 1e-6);
    }
  }
}

void TestSettings(RelevoCheck& check)
{
  // The threshold is in units of the array, whatever the spacing.
  const auto image = MakeFlowImage(60, 1, [](double x, double, double* v) { v[0] = x - 0.5; });
  image->SetSpacing(1e-3, 7.0, 1.0);
  vtkNew<vtkLineIntegralConvolution> filter;
  filter->SetInputData(image);
  for (double threshold : { -1.0, 0.0, 0.5, 12.0, 1e9 })
  {
    CHECK_CASE(threshold);
    filter->SetMaskThreshold(threshold);
    const std::vector<double> lic = RunLIC(filter);
    const std::vector<double> mask = ValuesOf(filter->GetOutput(), "LICMask");
    bool so = mask.size() == 60;
    for (std::size_t i = 0; so && i < mask.size(); ++i)
    {
      so = mask[i] == (static_cast<double>(i) <= threshold ? 1.0 : 0.0);
    }
    CHECK(so);
  }
  // Lines pass through pixels that are masked only because their vectors are below the threshold.
  filter->SetMaskThreshold(-1.0);
  const std::vector<double> all = RunLIC(filter);
  filter->EnhancedLICOff();
  const std::vector<double> plain = RunLIC(filter);
  filter->SetMaskThreshold(30.0);
  const std::vector<double> some = RunLIC(filter);
  CHECK_NOT_EQUAL(all, plain);
  CHECK(some.size() == 60 && std::equal(some.begin() + 31, some.end(), plain.begin() + 31));
  CHECK(some.size() == 60 && some[10] != plain[10]);

  filter->SetMaskThreshold(0.0);
  filter->SetNoDataMagnitude(20.0);
  RunLIC(filter);
  const std::vector<double> mask = ValuesOf(filter->GetOutput(), "LICMask");
  CHECK_EQUAL(std::count(mask.begin(), mask.end(), 1.0), 41); // pixels 0 and 20 to 59

  // The third component decides whether a value is missing, but it does not count for the length.
  const auto upward = MakeFlowImage(3, 1,
    [](double x, double, double* v)
    {
      v[0] = x < 1.0 ? 0.0 : 1.0;
      v[2] = x < 1.0 ? 5.0 : x < 2.0 ? 5.0 : std::numeric_limits<double>::quiet_NaN();
    });
  vtkNew<vtkLineIntegralConvolution> flat;
  flat->SetInputData(upward);
  RunLIC(flat);
  CHECK_EQUAL(ValuesOf(flat->GetOutput(), "LICMask"), (std::vector<double>{ 1.0, 0.0, 1.0 }));

  // Blanked points are masked.
  const auto blanked = MakeFlowImage(5, 1, MakeUniformField(1.0, 0.0));
  blanked->AllocatePointGhostArray()->SetValue(3, vtkDataSetAttributes::HIDDENPOINT);
  flat->SetInputData(blanked);
  RunLIC(flat);
  CHECK_EQUAL(
    ValuesOf(flat->GetOutput(), "LICMask"), (std::vector<double>{ 0.0, 0.0, 0.0, 1.0, 0.0 }));

  // An image without flow is masked everywhere.
  const auto noise = MakeNoiseImage(4, 4);
  flat->SetInputData(MakeFlowImage(4, 4, MakeUniformField(0.0, 0.0)));
  flat->SetNoiseData(noise);
  flat->SetEnhanceContrastToLIC();
  flat->SetAntiAlias(1);
  RelevoErrors errors(flat);
  CHECK_EQUAL(RunLIC(flat), ValuesOf(noise));
  CHECK(errors.None());
}
}

int TestLineIntegralConvolutionMask(int, char*[])
{
  RelevoCheck check;
  TestNoData(check);
  TestEnds(check);
  TestSettings(check);
  return check.GetResult();
}
