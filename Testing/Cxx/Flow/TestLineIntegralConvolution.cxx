// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkLineIntegralConvolution promises: without its second pass, each pixel is the mean of the noise
// along its streamline. References are explicit sums, exact circles, and streamlines integrated in
// small steps through the field.
#include "RelevoCheck.h"
#include "RelevoFlowImages.h"

#include "vtkSMPTools.h"

#include <iostream>

namespace
{
constexpr int Columns = 160;
constexpr int Rows = 120;

struct Place
{
  double X;
  double Y;
};

bool IsInside(const Place& p)
{
  return p.X >= 0.0 && p.Y >= 0.0 && p.X < Columns && p.Y < Rows;
}

// Mean of the noise at along(column, row, k) for k from -n to n. Each direction ends at the image's
// border.
template <typename Along>
std::vector<double> MeanAlong(vtkImageData* noise, int n, Along&& along)
{
  const RelevoGrey grey = GreyOf(ValuesOf(noise), noise->GetDimensions()[0]);
  std::vector<double> means;
  for (int row = 0; row < Rows; ++row)
  {
    for (int column = 0; column < Columns; ++column)
    {
      double sum = 0.0;
      int count = 0;
      for (int way : { -1, 1 })
      {
        for (int k = way > 0 ? 0 : 1; k <= n; ++k)
        {
          const Place p = along(column + 0.5, row + 0.5, way * k);
          if (!IsInside(p))
          {
            break;
          }
          sum += grey.At(static_cast<int>(p.X) % grey.Columns, static_cast<int>(p.Y) % grey.Rows);
          ++count;
        }
      }
      means.push_back(sum / count);
    }
  }
  return means;
}

vtkSmartPointer<vtkLineIntegralConvolution> MakePlain(vtkImageData* image, vtkImageData* noise)
{
  auto filter = vtkSmartPointer<vtkLineIntegralConvolution>::New();
  filter->SetInputData(image);
  filter->SetNoiseData(noise);
  filter->EnhancedLICOff();
  return filter;
}

// Share of pixels that differ by more than one of the 2 n + 1 samples can change the mean.
double ShareOfOthers(const std::vector<double>& a, const std::vector<double>& b, int n)
{
  std::size_t others = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    others += std::abs(a[i] - b[i]) > 1.0 / (n + 1) ? 1 : 0;
  }
  return static_cast<double>(others) / a.size();
}

double MeanDifference(const std::vector<double>& a, const std::vector<double>& b)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    sum += std::abs(a[i] - b[i]);
  }
  return sum / a.size();
}

// Along rows, columns and diagonals, steps lead from pixel centre to pixel centre, so the mean is
// exact.
void TestStraight(RelevoCheck& check)
{
  const auto noise = MakeNoiseImage(Columns, Rows);
  struct
  {
    double V[2];
    double StepSize;
    int Steps;
    bool Normalized;
  } const cases[] = { { { 1.0, 0.0 }, 1.0, 20, true }, { { 0.0, -3.0 }, 1.0, 7, true },
    { { -1e-20, 0.0 }, 2.0, 4, true }, { { 2.0, 2.0 }, std::sqrt(2.0), 11, true },
    { { 0.0, 3.0 }, 1.0, 9, false }, { { 0.25, 0.0 }, 8.0, 3, false },
    { { 1.0, 0.0 }, 1.0, 500, true } };
  for (const auto& c : cases)
  {
    auto filter = MakePlain(MakeFlowImage(Columns, Rows, MakeUniformField(c.V[0], c.V[1])), noise);
    filter->SetStepSize(c.StepSize);
    filter->SetNumberOfSteps(c.Steps);
    filter->SetNormalizeVectors(c.Normalized);
    const double scale = c.StepSize / (c.Normalized ? std::hypot(c.V[0], c.V[1]) : 1.0);
    const auto expected = MeanAlong(noise, c.Steps,
      [&](double x, double y, int k)
      {
        // Snaps to the pixel centre, however the square root of 2 is rounded.
        return Place{ std::floor(x + k * scale * c.V[0] + 1e-6 - 0.5) + 0.5,
          std::floor(y + k * scale * c.V[1] + 1e-6 - 0.5) + 0.5 };
      });
    CHECK_LESS(LargestDifference(RunLIC(filter), expected), 2e-6);
  }
}

// The streamlines of a vortex are exact circles.
void TestVortex(RelevoCheck& check)
{
  const double centre[2] = { 70.3, 61.7 };
  const auto noise = MakeNoiseImage(61, 47, 2); // is repeated over the image
  auto filter = MakePlain(MakeFlowImage(Columns, Rows,
                            [&](double x, double y, double* v)
                            {
                              v[0] = centre[1] - y;
                              v[1] = x - centre[0];
                            }),
    noise);
  const auto expected = MeanAlong(noise, 20,
    [&](double x, double y, int k)
    {
      const double dx = x - centre[0];
      const double dy = y - centre[1];
      const double angle = k / std::hypot(dx, dy);
      return Place{ centre[0] + std::cos(angle) * dx - std::sin(angle) * dy,
        centre[1] + std::sin(angle) * dx + std::cos(angle) * dy };
    });
  const std::vector<double> lic = RunLIC(filter);
  std::cout << "vortex: mean difference " << MeanDifference(lic, expected) << ", others "
            << ShareOfOthers(lic, expected, 20) << "\n";
  // Few samples fall into the neighbouring texel, except close to the centre.
  CHECK_LESS(MeanDifference(lic, expected), 1e-3);
  CHECK_LESS(ShareOfOthers(lic, expected, 20), 0.002);
}

// In a field of rotating cells, streamlines are integrated by fourth-order steps through the field.
void TestCells(RelevoCheck& check)
{
  const auto field = [](double x, double y, double* v)
  {
    v[0] = std::sin(0.07 * x) * std::cos(0.05 * y);
    v[1] = -1.4 * std::cos(0.07 * x) * std::sin(0.05 * y);
  };
  const auto direction = [&](const Place& p)
  {
    double v[2];
    field(p.X, p.Y, v);
    const double length = std::hypot(v[0], v[1]);
    return Place{ v[0] / length, v[1] / length };
  };
  const auto walk = [&](double x, double y, int k)
  {
    const double h = (k < 0 ? -1.0 : 1.0) / 3.0;
    Place p{ x, y };
    for (int i = 0; i < 3 * std::abs(k); ++i)
    {
      const Place a = direction(p);
      const Place b = direction({ p.X + 0.5 * h * a.X, p.Y + 0.5 * h * a.Y });
      const Place c = direction({ p.X + 0.5 * h * b.X, p.Y + 0.5 * h * b.Y });
      const Place d = direction({ p.X + h * c.X, p.Y + h * c.Y });
      p.X += h / 6.0 * (a.X + 2.0 * b.X + 2.0 * c.X + d.X);
      p.Y += h / 6.0 * (a.Y + 2.0 * b.Y + 2.0 * c.Y + d.Y);
    }
    return p;
  };
  const auto noise = MakeNoiseImage(Columns, Rows, 3);
  auto filter = MakePlain(MakeFlowImage(Columns, Rows, field), noise);
  filter->SetNumberOfSteps(12);
  const std::vector<double> lic = RunLIC(filter);
  const auto expected = MeanAlong(noise, 12, walk);
  std::cout << "cells: mean difference " << MeanDifference(lic, expected) << ", others "
            << ShareOfOthers(lic, expected, 12) << "\n";
  CHECK_LESS(MeanDifference(lic, expected), 2e-3);
  CHECK_LESS(ShareOfOthers(lic, expected, 12), 0.01);

  // The number of threads does not change the result.
  const std::string backend = vtkSMPTools::GetBackend();
  for (const char* other : { "Sequential", "STDThread" })
  {
    CHECK_CASE(other);
    CHECK(vtkSMPTools::SetBackend(other));
    filter->Modified();
    CHECK_EQUAL(RunLIC(filter), lic);
  }
  vtkSMPTools::SetBackend(backend.c_str());
}
}

int TestLineIntegralConvolution(int, char*[])
{
  RelevoCheck check;
  TestStraight(check);
  TestVortex(check);
  TestCells(check);
  return check.GetResult();
}
