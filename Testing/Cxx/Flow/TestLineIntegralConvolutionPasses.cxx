// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkLineIntegralConvolution promises: the second pass, contrast enhancement and antialiasing work
// as its settings describe.
#include "RelevoCheck.h"
#include "RelevoFlowImages.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"

namespace
{
constexpr int Columns = 120;
constexpr int Rows = 80;

vtkSmartPointer<vtkLineIntegralConvolution> MakeFilter(vtkImageData* noise)
{
  auto filter = vtkSmartPointer<vtkLineIntegralConvolution>::New();
  filter->SetInputData(MakeFlowImage(Columns, Rows,
    [](double x, double y, double* v)
    {
      const bool hole = std::hypot(x - 30.0, y - 20.0) < 6.0;
      v[0] = hole ? 1e9 : 37.0 - y;
      v[1] = hole ? 1e9 : x - 66.0;
    }));
  filter->SetNoiseData(noise);
  return filter;
}

vtkSmartPointer<vtkImageData> MakeImage(const RelevoGrey& grey)
{
  const auto image = MakeNoiseImage(grey.Columns, grey.Rows);
  for (std::size_t i = 0; i < grey.Values.size(); ++i)
  {
    image->GetPointData()->GetScalars()->SetComponent(i, 0, grey.Values[i]);
  }
  return image;
}

// The mask stored in the array "LICMask" of an image.
class Mask
{
public:
  explicit Mask(vtkImageData* lic)
    : Grey(GreyOf(ValuesOf(lic, "LICMask"), Columns))
  {
  }
  // Whether no pixel within these distances is masked or outside the image.
  bool IsClear(int column, int row, int across, int along) const
  {
    bool clear = column >= across && row >= along && column + across < this->Grey.Columns &&
      row + along < this->Grey.Rows;
    for (int j = -along; clear && j <= along; ++j)
    {
      for (int i = -across; clear && i <= across; ++i)
      {
        clear = this->Grey.At(column + i, row + j) == 0.0;
      }
    }
    return clear;
  }

private:
  RelevoGrey Grey;
};

RelevoGrey Sharpen(const RelevoGrey& image, const Mask& mask)
{
  RelevoGrey sharp = image;
  for (int row = 0; row < image.Rows; ++row)
  {
    for (int column = 0; column < image.Columns; ++column)
    {
      if (mask.IsClear(column, row, 1, 1))
      {
        double neighbours = 0.0;
        for (int i = 0; i < 9; ++i)
        {
          neighbours += image.At(column + i % 3 - 1, row + i / 3 - 1);
        }
        const double laplacian = 9.0 * image.At(column, row) - neighbours;
        sharp.At(column, row) = std::min(std::max(image.At(column, row) + laplacian, 0.0), 1.0);
      }
    }
  }
  return sharp;
}

RelevoGrey Smooth(const RelevoGrey& image, const Mask& mask, int across, int along)
{
  RelevoGrey smooth = image;
  for (int row = 0; row < image.Rows; ++row)
  {
    for (int column = 0; column < image.Columns; ++column)
    {
      if (mask.IsClear(column, row, across, along))
      {
        smooth.At(column, row) =
          (image.At(column - across, row - along) + 5.0 * image.At(column, row) +
            image.At(column + across, row + along)) /
          7.0;
      }
    }
  }
  return smooth;
}

RelevoGrey Stretch(const RelevoGrey& image, const Mask& mask, double low, double high)
{
  double smallest = 2.0;
  double largest = -1.0;
  RelevoGrey stretched = image;
  for (int pass = 0; pass < 2; ++pass)
  {
    const double m = smallest + low * (largest - smallest);
    const double M = largest - high * (largest - smallest);
    for (int row = 0; row < image.Rows; ++row)
    {
      for (int column = 0; column < image.Columns; ++column)
      {
        const double value = image.At(column, row);
        if (mask.IsClear(column, row, 0, 0) && pass == 0)
        {
          smallest = std::min(smallest, value);
          largest = std::max(largest, value);
        }
        else if (mask.IsClear(column, row, 0, 0))
        {
          stretched.At(column, row) = std::min(std::max((value - m) / (M - m), 0.0), 1.0);
        }
      }
    }
  }
  return stretched;
}

RelevoGrey RunGrey(vtkLineIntegralConvolution* filter)
{
  return GreyOf(RunLIC(filter), Columns);
}

// A second filter computes the second pass for comparison.
void TestSecondPass(RelevoCheck& check, bool contrast, int steps)
{
  const auto noise = MakeNoiseImage(50, 50);
  auto filter = MakeFilter(noise);
  filter->SetNumberOfSteps(steps);
  filter->EnhancedLICOff();
  const RelevoGrey first = RunGrey(filter);
  const Mask mask(filter->GetOutput());

  auto second =
    MakeFilter(MakeImage(Sharpen(contrast ? Stretch(first, mask, 0.0, 0.0) : first, mask)));
  second->EnhancedLICOff();
  second->SetNumberOfSteps(std::max(steps / 2, 1));
  RelevoGrey expected = RunGrey(second);
  expected = contrast ? Stretch(expected, mask, 0.1, -0.2) : expected;

  filter->EnhancedLICOn();
  filter->SetEnhanceContrast(contrast ? 1 : 0);
  filter->SetLowLICContrastEnhancementFactor(0.1);
  filter->SetHighLICContrastEnhancementFactor(-0.2);
  CHECK_LESS(LargestDifference(RunLIC(filter), expected.Values), 1e-5);
}

void TestFilters(RelevoCheck& check)
{
  auto filter = MakeFilter(MakeNoiseImage(50, 50));
  filter->EnhancedLICOff();
  RelevoGrey expected = RunGrey(filter);
  const RelevoMoments before = MomentsOf(expected.Values);
  const Mask mask(filter->GetOutput());

  filter->SetEnhanceContrastToLIC();
  CHECK_LESS(LargestDifference(RunLIC(filter), Stretch(expected, mask, 0.0, 0.0).Values), 1e-5);
  filter->SetEnhanceContrastToOff();

  for (int times = 1; times <= 3; ++times)
  {
    expected = Smooth(Smooth(expected, mask, 1, 0), mask, 0, 1);
    filter->SetAntiAlias(times);
    CHECK_LESS(LargestDifference(RunLIC(filter), expected.Values), 1e-5);
  }
  CHECK_NEAR(MomentsOf(expected.Values).Mean, before.Mean, 1e-3);
  CHECK_LESS(MomentsOf(expected.Values).StandardDeviation, 0.8 * before.StandardDeviation);
  filter->SetEnhanceContrastToLIC();
  CHECK_LESS(LargestDifference(RunLIC(filter), Stretch(expected, mask, 0.0, 0.0).Values), 1e-5);
}

// Constant noise has no contrast to stretch.
void TestFlatNoise(RelevoCheck& check)
{
  const auto noise = MakeNoiseImage(3, 3);
  noise->GetPointData()->GetScalars()->Fill(0.375);
  auto filter = MakeFilter(noise);
  filter->SetEnhanceContrastToLIC();
  filter->SetAntiAlias(1);
  const std::vector<double> lic = RunLIC(filter);
  CHECK_LESS(LargestDifference(lic, std::vector<double>(lic.size(), 0.375)), 1e-5);
}
}

int TestLineIntegralConvolutionPasses(int, char*[])
{
  RelevoCheck check;
  for (bool contrast : { false, true })
  {
    CHECK_CASE(contrast);
    for (int steps : { 20, 5, 1 })
    {
      CHECK_CASE(steps);
      TestSecondPass(check, contrast, steps);
    }
  }
  TestFilters(check);
  TestFlatNoise(check);
  return check.GetResult();
}
