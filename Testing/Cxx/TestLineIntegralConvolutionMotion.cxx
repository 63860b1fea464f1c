// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkLineIntegralConvolution shows the way of the flow: by phase, in a loop, and by oriented lines.
#include "RelevoCheck.h"
#include "RelevoFlowImages.h"

#include "vtkLICNoiseSource.h"

#include <initializer_list>

namespace
{
constexpr int Columns = 150;
constexpr int Rows = 90;
constexpr int Steps = 20;

double MeanDifference(const std::vector<double>& a, const std::vector<double>& b)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
  {
    sum += std::abs(a[i] - b[i]) / a.size();
  }
  return sum;
}

// By how many columns to the right the image `moved` is like `image` the most.
int FindShift(const RelevoGrey& image, const RelevoGrey& moved)
{
  constexpr int Most = 15;
  const double mean = MomentsOf(image.Values).Mean;
  int best = 0;
  double most = -VTK_DOUBLE_MAX;
  for (int shift = -Most; shift <= Most; ++shift)
  {
    double sum = 0.0;
    for (int row = 0; row < image.Rows; ++row)
    {
      for (int column = 2 * Steps; column < image.Columns - 2 * Steps; ++column)
      {
        sum += (image.At(column - shift, row) - mean) * (moved.At(column, row) - mean);
      }
    }
    best = sum > most ? shift : best;
    most = std::max(sum, most);
  }
  return best;
}

void TestPhase(RelevoCheck& check)
{
  vtkNew<vtkLineIntegralConvolution> filter;
  filter->SetInputData(MakeFlowImage(Columns, Rows,
    [](double x, double y, double* v)
    {
      v[0] = 40.0 - y;
      v[1] = x - 60.0;
    }));
  const auto at = [&](double phase)
  {
    filter->SetPhase(phase);
    return RunLIC(filter);
  };
  for (bool oriented : { false, true })
  {
    filter->SetOrientedLIC(oriented);
    const std::vector<double> still = at(0.0);
    for (double whole : { 1.0, 2.0, -1.0, 1.0 - 1e-12, -1e-20 })
    {
      CHECK(at(whole) == still);
    }
    CHECK(at(0.375) == at(3.375));
    CHECK(at(0.375) == at(-0.625));
    CHECK(at(0.375) != still);

    // Smooth, around the loop and across its end.
    const double large = MeanDifference(at(0.5), still);
    for (double phase : { -0.005, 0.1, 0.249, 0.5, 0.745, 0.99 })
    {
      CHECK(MeanDifference(at(phase + 0.01), at(phase)) < 0.2 * large);
    }
    // No phase is much paler than the others.
    CHECK(MomentsOf(at(0.5)).StandardDeviation > 0.75 * MomentsOf(still).StandardDeviation);
    CHECK_NEAR(MomentsOf(at(0.5)).Mean, MomentsOf(still).Mean, 0.005);
  }
}

void TestDirection(RelevoCheck& check)
{
  for (bool enhanced : { false, true })
  {
    for (double sign : { 1.0, -1.0 })
    {
      vtkNew<vtkLineIntegralConvolution> filter;
      filter->SetInputData(MakeFlowImage(Columns, Rows, MakeUniformField(sign, 0.0)));
      filter->SetNumberOfSteps(Steps);
      filter->SetEnhancedLIC(enhanced);
      const RelevoGrey still = GreyOf(RunLIC(filter), Columns);
      filter->SetPhase(0.25);
      const RelevoGrey quarter = GreyOf(RunLIC(filter), Columns);
      CHECK_NEAR(FindShift(still, quarter), sign * 0.25 * Steps, 1.0);
      filter->SetPhase(0.4);
      CHECK_NEAR(FindShift(quarter, GreyOf(RunLIC(filter), Columns)), sign * 0.15 * Steps, 1.0);
    }
  }
}

// One dot becomes a line that is the brightest at its head, downstream.
void TestOrientedDot(RelevoCheck& check)
{
  vtkNew<vtkImageData> dot;
  dot->SetDimensions(101, 1, 1);
  dot->AllocateScalars(VTK_FLOAT, 1);
  dot->GetPointData()->GetScalars()->Fill(0.0);
  dot->GetPointData()->GetScalars()->SetComponent(50, 0, 1.0);
  for (double sign : { 1.0, -1.0 })
  {
    vtkNew<vtkLineIntegralConvolution> filter;
    filter->SetInputData(MakeFlowImage(101, 1, MakeUniformField(sign, 0.0)));
    filter->SetNoiseData(dot);
    filter->SetNumberOfSteps(Steps);
    filter->EnhancedLICOff();
    filter->OrientedLICOn();
    const std::vector<double> lic = RunLIC(filter);
    // Weights grow linearly from the sample that is furthest downstream to that furthest upstream.
    const double sum = (2.0 * Steps + 1.0) * (Steps + 1.0);
    for (int k = -30; k <= 30 && CHECK(lic.size() == 101); ++k)
    {
      CHECK_NEAR(lic[50 + static_cast<int>(sign) * k],
        std::abs(k) <= Steps ? (k + Steps + 1.0) / sum : 0.0, 1e-6);
    }
    filter->OrientedLICOff();
    CHECK_NEAR(RunLIC(filter)[50], 1.0 / (2.0 * Steps + 1.0), 1e-6);
  }
}

// Sparse noise, both passes: brightness rises slowly downstream and falls abruptly after the heads.
void TestOrientedImpulses(RelevoCheck& check)
{
  vtkNew<vtkLICNoiseSource> noise;
  noise->SetImpulseNoiseProbability(0.01);
  noise->SetNoiseTypeToUniform();
  noise->SetMinNoiseValue(0.9);
  noise->SetMaxNoiseValue(1.0);
  noise->SetNoiseGrainSize(2);
  for (double sign : { 1.0, -1.0 })
  {
    vtkNew<vtkLineIntegralConvolution> filter;
    filter->SetInputData(MakeFlowImage(400, 200, MakeUniformField(sign, 0.0)));
    filter->SetNoiseConnection(noise->GetOutputPort());
    filter->OrientedLICOn();
    for (bool enhanced : { false, true })
    {
      filter->SetEnhancedLIC(enhanced);
      const RelevoGrey lic = GreyOf(RunLIC(filter), 400);
      double skew = 0.0;
      for (int row = 0; row < lic.Rows; ++row)
      {
        for (int column = 50; column < 350; ++column)
        {
          skew += std::pow(lic.At(column + 1, row) - lic.At(column, row), 3.0);
        }
      }
      CHECK(sign * skew < 0.0);
    }
  }
}
}

int TestLineIntegralConvolutionMotion(int, char*[])
{
  RelevoCheck check;
  TestPhase(check);
  TestDirection(check);
  TestOrientedDot(check);
  TestOrientedImpulses(check);
  return check.GetResult();
}
