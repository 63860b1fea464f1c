// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Shape and number of the patterns' triangles, in the equilateral triangle, against SUAPT and
// against what no triangulation can surpass.
#include "RelevoCheck.h"
#include "RelevoPatternQuality.h"

#include "Patterns/RefinementPattern.h"
#include "vtkRefinementPatternTable.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <vector>

namespace
{
constexpr double Pi = 3.14159265358979323846;
constexpr int HighestLevel = vtkRefinementPatternTable::HighestLevel;

double Degrees(double radians)
{
  return 180.0 / Pi * radians;
}

/// The smallest angle of each triangle, in degrees; degenerate triangles are left out.
std::vector<double> SmallestAngles(const relevo::RefinementPattern& pattern)
{
  std::vector<double> angles;
  for (const RelevoPatternQuality::Shape& shape : RelevoPatternQuality::GetShapes(pattern))
  {
    if (!shape.IsDegenerate())
    {
      angles.push_back(shape.SmallestAngle);
    }
  }
  return angles;
}

/// The largest angle that a triangulation can have at a corner whose edges' first points are at
/// distances of this ratio: m triangles there have 60 degrees and m ratios of sides to share.
double LargestPossibleAngle(double ratio)
{
  double largest = 0.0;
  for (int m = 1; m <= 16; ++m)
  {
    const double apex = Pi / 3.0 / m;
    const double base = std::atan2(std::sin(apex), std::pow(ratio, 1.0 / m) - std::cos(apex));
    largest = std::max(largest, Degrees(std::min(apex, base)));
  }
  return largest;
}

double Minimum(const std::vector<double>& values)
{
  return *std::min_element(values.begin(), values.end());
}

double Mean(const std::vector<double>& values)
{
  double sum = 0.0;
  for (double value : values)
  {
    sum += value;
  }
  return sum / values.size();
}
}

int TestRefinementPatternQuality(int, char*[])
{
  RelevoCheck check;
  vtkNew<vtkRefinementPatternTable> table;
  table->SetMaximumLevel(HighestLevel);

  std::array<std::vector<double>, HighestLevel + 1> minima, suaptMinima, counts, suaptCounts;
  std::array<int, 12> histogram = {};
  std::array<int, 12> suaptHistogram = {};
  double slowest = 0.0;
  double total = 0.0;
  double fewest = 10.0;
  double most = 0.0;
  for (int i = 0; i <= HighestLevel; ++i)
  {
    for (int j = 0; j <= i; ++j)
    {
      for (int k = 0; k <= j; ++k)
      {
        const int levels[3] = { i, j, k };
        const auto start = std::chrono::steady_clock::now();
        const auto made = table->GetPatternOfSegments(1 << i, 1 << j, 1 << k);
        const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
        const relevo::RefinementPattern& pattern = *made;
        slowest = std::max(slowest, seconds.count());
        total += seconds.count();
        const auto angles = SmallestAngles(pattern);
        CHECK(static_cast<int>(angles.size()) == pattern.GetNumberOfTriangles());
        if (i == k)
        {
          CHECK_NEAR(Minimum(angles), 60.0, 1e-4);
          CHECK(pattern.GetNumberOfTriangles() == 1 << (2 * i));
          continue;
        }

        // Between the geometric and the arithmetic mean of the levels' uniform patterns.
        const double geometric = std::pow(4.0, (i + j + k) / 3.0);
        const double arithmetic = (std::pow(4.0, i) + std::pow(4.0, j) + std::pow(4.0, k)) / 3.0;
        fewest = std::min(fewest, pattern.GetNumberOfTriangles() / geometric);
        most = std::max(most, pattern.GetNumberOfTriangles() / arithmetic);

        const auto suapt = SmallestAngles(RelevoPatternQuality::MakeSuaptPattern(table, levels));
        const int difference = i - k;
        minima[difference].push_back(Minimum(angles));
        counts[difference].push_back(angles.size());
        suaptMinima[difference].push_back(Minimum(suapt));
        suaptCounts[difference].push_back(suapt.size());
        // Across one level SUAPT's halved equilateral triangles have the largest angle possible.
        CHECK(difference == 1 ? Minimum(angles) > Minimum(suapt) - 0.1
                              : Minimum(angles) > 1.8 * Minimum(suapt));
        CHECK(Minimum(angles) > 0.8 * LargestPossibleAngle(1 << (i - k)));
        for (double angle : angles)
        {
          ++histogram[std::min(11, static_cast<int>(angle / 5.0))];
        }
        for (double angle : suapt)
        {
          ++suaptHistogram[std::min(11, static_cast<int>(angle / 5.0))];
        }
      }
    }
  }

  std::cout << std::fixed << std::setprecision(2)
            << "Smallest angles (degrees) of adaptive patterns, by the difference of levels\n\n"
            << "| difference | patterns | possible | smallest | mean of smallest | mean triangles "
               "| SUAPT smallest | SUAPT mean of smallest | SUAPT mean triangles |\n"
            << "|---|---|---|---|---|---|---|---|---|\n";
  for (int d = 1; d <= HighestLevel; ++d)
  {
    std::cout << "| " << d << " | " << minima[d].size() << " | " << LargestPossibleAngle(1 << d)
              << " | " << Minimum(minima[d]) << " | " << Mean(minima[d]) << " | " << Mean(counts[d])
              << " | " << Minimum(suaptMinima[d]) << " | " << Mean(suaptMinima[d]) << " | "
              << Mean(suaptCounts[d]) << " |\n";
  }
  std::cout << "\nTriangles by smallest angle, in steps of 5 degrees\nours:  ";
  for (int count : histogram)
  {
    std::cout << " " << count;
  }
  std::cout << "\nSUAPT: ";
  for (int count : suaptHistogram)
  {
    std::cout << " " << count;
  }
  std::cout << "\n\nTriangles against the geometric mean of 4^level: at least " << fewest
            << "; against the arithmetic mean: at most " << most << "\nTime: " << 1e3 * total
            << " ms for all patterns, " << 1e3 * slowest
            << " ms for the slowest; memory: " << table->GetMemorySize() << " bytes\n";

  // Measured 30.0, 20.0, 17.6, 13.9, 11.3, 9.3, 8.2 degrees.
  const double bounds[HighestLevel + 1] = { 0.0, 29.9, 19.5, 17.0, 13.5, 11.0, 9.0, 8.0 };
  for (int d = 1; d <= HighestLevel; ++d)
  {
    CHECK(Minimum(minima[d]) > bounds[d]);
    CHECK(Mean(counts[d]) < Mean(suaptCounts[d]));
    CHECK(d == 1 || Mean(minima[d]) > 2.0 * Mean(suaptMinima[d]));
  }
  CHECK(30 * (histogram[0] + histogram[1]) < suaptHistogram[0] + suaptHistogram[1]);
  CHECK(histogram[0] == 0);
  CHECK(fewest > 0.8);
  CHECK(most < 1.5);
  return check.GetResult();
}
