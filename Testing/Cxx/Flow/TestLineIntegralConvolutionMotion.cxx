// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves flow.md: Phase animates the streaks in a loop without a seam, and OrientedLIC shows the
// direction of the flow.
#include "RelevoCheck.h"
#include "RelevoFlowImages.h"

#include "vtkDataArray.h"
#include "vtkLICNoiseSource.h"
#include "vtkPointData.h"

#include <initializer_list>
#include <iostream>

namespace
{
constexpr int Columns = 400;
constexpr int Rows = 25;
constexpr int Steps = 20;
constexpr int Period = 3 * Steps + 1;

double MeanDifference(const std::vector<double>& a, const std::vector<double>& b)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
  {
    sum += std::abs(a[i] - b[i]) / a.size();
  }
  return sum;
}

// Values of the pixels whose lines do not reach the border.
std::vector<double> InnerValues(const RelevoGrey& image)
{
  std::vector<double> values;
  for (int row = 0; row < image.Rows; ++row)
  {
    for (int column = 5 * Steps; column < image.Columns - 5 * Steps; ++column)
    {
      values.push_back(image.At(column, row));
    }
  }
  return values;
}

// Mean squared difference between an image and another one shifted to the right, away from the
// borders.
double DifferenceOfMoved(const RelevoGrey& image, const RelevoGrey& other, int columns)
{
  double sum = 0.0;
  for (int row = 0; row < image.Rows; ++row)
  {
    for (int column = 3 * Steps; column < image.Columns - 3 * Steps; ++column)
    {
      sum += std::pow(image.At(column, row) - other.At(column - columns, row), 2.0);
    }
  }
  return sum;
}

void TestPhase(RelevoCheck& check)
{
  vtkNew<vtkLineIntegralConvolution> filter;
  filter->SetInputData(MakeFlowImage(Columns, Rows,
    [](double x, double y, double* v)
    {
      v[0] = 10.0 - y;
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
      CHECK_CASE(whole);
      CHECK_EQUAL(at(whole), still);
    }
    CHECK_EQUAL(at(0.375), at(3.375));
    CHECK_EQUAL(at(0.375), at(-0.625));
    CHECK_NOT_EQUAL(at(0.375), still);

    // The animation is smooth within the loop and across its end.
    const double large = MeanDifference(at(0.5), still);
    for (double phase : { -0.005, 0.1, 0.249, 0.5, 0.745, 0.99 })
    {
      CHECK_CASE(phase);
      CHECK_LESS(MeanDifference(at(phase + 0.01), at(phase)), 0.2 * large);
    }
  }
}

// In a loop of Period frames, the pattern moves one sample downstream per frame.
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
      const RelevoMoments still = MomentsOf(InnerValues(GreyOf(RunLIC(filter), Columns)));
      for (int frame : { 0, Period / 4, Period / 2, Period - 1 })
      {
        filter->SetPhase(static_cast<double>(frame) / Period);
        const RelevoGrey image = GreyOf(RunLIC(filter), Columns);
        filter->SetPhase((frame + 1.0) / Period);
        const RelevoGrey next = GreyOf(RunLIC(filter), Columns);
        const double unmoved = DifferenceOfMoved(next, image, 0);
        const int downstream = static_cast<int>(sign);
        const double moved = DifferenceOfMoved(next, image, downstream) / unmoved;
        const double movedBack = DifferenceOfMoved(next, image, -downstream) / unmoved;
        std::cout << "frame " << frame << ", enhanced " << enhanced << ": moved downstream "
                  << moved << ", upstream " << movedBack << "\n";
        CHECK_LESS(moved, 0.4);
        CHECK_GREATER(movedBack, 2.0);
        // All phases have the same mean and contrast.
        const RelevoMoments moments = MomentsOf(InnerValues(image));
        CHECK_NEAR(moments.Mean, still.Mean, 0.01);
        CHECK_NEAR(moments.StandardDeviation / still.StandardDeviation, 1.0, 0.1);
      }
    }
  }
}

// A single dot becomes a line whose brightest end, the head, is downstream.
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
    // Weights grow linearly from the sample furthest downstream to the one furthest upstream.
    const double sum = (2.0 * Steps + 1.0) * (Steps + 1.0);
    for (int k = -30; k <= 30 && CHECK_EQUAL(lic.size(), 101); ++k)
    {
      CHECK_NEAR(lic[50 + static_cast<int>(sign) * k],
        std::abs(k) <= Steps ? (k + Steps + 1.0) / sum : 0.0, 1e-6);
    }
    filter->OrientedLICOff();
    CHECK_NEAR(RunLIC(filter)[50], 1.0 / (2.0 * Steps + 1.0), 1e-6);
  }
}

// With sparse noise and both passes, brightness rises slowly downstream and falls abruptly after
// the heads.
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
    CHECK_CASE(sign);
    vtkNew<vtkLineIntegralConvolution> filter;
    filter->SetInputData(MakeFlowImage(400, 200, MakeUniformField(sign, 0.0)));
    filter->SetNoiseConnection(noise->GetOutputPort());
    filter->OrientedLICOn();
    for (bool enhanced : { false, true })
    {
      CHECK_CASE(enhanced);
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
      CHECK_LESS(sign * skew, 0.0);
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
