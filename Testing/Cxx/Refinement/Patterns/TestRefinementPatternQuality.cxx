// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkRefinementPatternTable promises the number of triangles and their smallest angles. In the
// equilateral triangle, they are compared with SUAPT and with the theoretical optimum.
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
#include <memory>
#include <vector>

namespace
{
constexpr double Pi = 3.14159265358979323846;
constexpr int HighestLevel = vtkRefinementPatternTable::HighestLevel;

double Degrees(double radians)
{
  return 180.0 / Pi * radians;
}

/// Smallest angle of each triangle in degrees. Degenerate triangles are skipped.
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

/// Largest possible smallest angle at a corner whose edges' first points have distances of this
/// ratio: m triangles share 60 degrees and m ratios of sides.
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

// Counts triangles by their smallest angle, in steps of 5 degrees.
using Histogram = std::array<int, 12>;

void AddAngles(Histogram& histogram, const std::vector<double>& angles)
{
  for (double angle : angles)
  {
    ++histogram[std::min(11, static_cast<int>(angle / 5.0))];
  }
}

// Quality of our patterns or of SUAPT's.
struct Quality
{
  void Add(int difference, const std::vector<double>& angles)
  {
    this->Minima[difference].push_back(Minimum(angles));
    this->Counts[difference].push_back(angles.size());
    AddAngles(this->Angles, angles);
  }

  // Of each adaptive pattern, by the difference of its levels.
  std::array<std::vector<double>, HighestLevel + 1> Minima;
  std::array<std::vector<double>, HighestLevel + 1> Counts;
  Histogram Angles = {};
};

// Results over all patterns.
struct Survey
{
  Quality Ours;
  Quality Suapt;
  // Triangles relative to the geometric and the arithmetic mean of the levels' uniform patterns.
  double Fewest = 10.0;
  double Most = 0.0;
  // In seconds.
  double Slowest = 0.0;
  double Total = 0.0;
};

std::shared_ptr<const relevo::RefinementPattern> MakeTimedPattern(
  vtkRefinementPatternTable* table, const int levels[3], Survey& survey)
{
  const auto start = std::chrono::steady_clock::now();
  auto pattern = table->GetPatternOfSegments(1 << levels[0], 1 << levels[1], 1 << levels[2]);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  survey.Slowest = std::max(survey.Slowest, seconds.count());
  survey.Total += seconds.count();
  return pattern;
}

void TestPattern(
  RelevoCheck& check, vtkRefinementPatternTable* table, const int levels[3], Survey& survey)
{
  const auto made = MakeTimedPattern(table, levels, survey);
  const relevo::RefinementPattern& pattern = *made;
  const auto angles = SmallestAngles(pattern);
  CHECK_EQUAL(static_cast<int>(angles.size()), pattern.GetNumberOfTriangles());
  const int i = levels[0];
  const int j = levels[1];
  const int k = levels[2];
  if (i == k)
  {
    CHECK_NEAR(Minimum(angles), 60.0, 1e-4);
    CHECK(pattern.GetNumberOfTriangles() == 1 << (2 * i));
    return;
  }

  // The count lies between the geometric and the arithmetic mean of the uniform patterns.
  const double geometric = std::pow(4.0, (i + j + k) / 3.0);
  const double arithmetic = (std::pow(4.0, i) + std::pow(4.0, j) + std::pow(4.0, k)) / 3.0;
  survey.Fewest = std::min(survey.Fewest, pattern.GetNumberOfTriangles() / geometric);
  survey.Most = std::max(survey.Most, pattern.GetNumberOfTriangles() / arithmetic);

  const auto suapt = SmallestAngles(RelevoPatternQuality::MakeSuaptPattern(table, levels));
  const int difference = i - k;
  survey.Ours.Add(difference, angles);
  survey.Suapt.Add(difference, suapt);
  // For one level of difference, SUAPT's halved equilateral triangles have the largest possible
  // angle.
  CHECK(difference == 1 ? Minimum(angles) > Minimum(suapt) - 0.1
                        : Minimum(angles) > 1.8 * Minimum(suapt));
  CHECK_GREATER(Minimum(angles), 0.8 * LargestPossibleAngle(1 << difference));
}

void Print(const Survey& survey, vtkRefinementPatternTable* table)
{
  std::cout << std::fixed << std::setprecision(2)
            << "Smallest angles (degrees) of adaptive patterns, by the difference of levels\n\n"
            << "| difference | patterns | possible | smallest | mean of smallest | mean triangles "
               "| SUAPT smallest | SUAPT mean of smallest | SUAPT mean triangles |\n"
            << "|---|---|---|---|---|---|---|---|---|\n";
  const Quality& ours = survey.Ours;
  const Quality& suapt = survey.Suapt;
  for (int d = 1; d <= HighestLevel; ++d)
  {
    std::cout << "| " << d << " | " << ours.Minima[d].size() << " | "
              << LargestPossibleAngle(1 << d) << " | " << Minimum(ours.Minima[d]) << " | "
              << Mean(ours.Minima[d]) << " | " << Mean(ours.Counts[d]) << " | "
              << Minimum(suapt.Minima[d]) << " | " << Mean(suapt.Minima[d]) << " | "
              << Mean(suapt.Counts[d]) << " |\n";
  }
  std::cout << "\nTriangles by smallest angle, in steps of 5 degrees\nours:  ";
  for (int count : ours.Angles)
  {
    std::cout << " " << count;
  }
  std::cout << "\nSUAPT: ";
  for (int count : suapt.Angles)
  {
    std::cout << " " << count;
  }
  std::cout << "\n\nTriangles relative to the geometric mean of 4^level: at least " << survey.Fewest
            << "; to the arithmetic mean: at most " << survey.Most
            << "\nTime: " << 1e3 * survey.Total << " ms for all patterns, " << 1e3 * survey.Slowest
            << " ms for the slowest; memory: " << table->GetMemorySize() << " bytes\n";
}

// The measured angles are 30.0, 20.0, 17.6, 13.9, 11.3, 9.3 and 8.2 degrees.
void TestSurvey(RelevoCheck& check, const Survey& survey)
{
  const Quality& ours = survey.Ours;
  const Quality& suapt = survey.Suapt;
  const double bounds[HighestLevel + 1] = { 0.0, 29.9, 19.5, 17.0, 13.5, 11.0, 9.0, 8.0 };
  for (int d = 1; d <= HighestLevel; ++d)
  {
    CHECK_GREATER(Minimum(ours.Minima[d]), bounds[d]);
    CHECK_LESS(Mean(ours.Counts[d]), Mean(suapt.Counts[d]));
    CHECK(d == 1 || Mean(ours.Minima[d]) > 2.0 * Mean(suapt.Minima[d]));
  }
  CHECK_LESS(30 * (ours.Angles[0] + ours.Angles[1]), suapt.Angles[0] + suapt.Angles[1]);
  CHECK_EQUAL(ours.Angles[0], 0);
  CHECK_GREATER(survey.Fewest, 0.8);
  CHECK_LESS(survey.Most, 1.5);
}
}

int TestRefinementPatternQuality(int, char*[])
{
  RelevoCheck check;
  vtkNew<vtkRefinementPatternTable> table;
  table->SetMaximumLevel(HighestLevel);
  Survey survey;
  for (int i = 0; i <= HighestLevel; ++i)
  {
    for (int j = 0; j <= i; ++j)
    {
      for (int k = 0; k <= j; ++k)
      {
        const int levels[3] = { i, j, k };
        TestPattern(check, table, levels, survey);
      }
    }
  }
  Print(survey, table);
  TestSurvey(check, survey);
  return check.GetResult();
}
