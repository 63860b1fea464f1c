// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Buffers/RefinementLevelTable.h"

#include "Patterns/RefinementPattern.h"
#include "Patterns/SegmentSteps.h"
#include "vtkLookupTable.h"
#include "vtkMath.h"
#include "vtkRefinementPatternTable.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace relevo
{
namespace
{
// Every eighth colour of matplotlib's viridis (public domain): perceptually uniform, in grey as
// well.
constexpr int NumberOfAnchors = 9;
constexpr double Viridis[NumberOfAnchors][3] = { { 0.267, 0.005, 0.329 }, { 0.278, 0.176, 0.482 },
  { 0.231, 0.322, 0.545 }, { 0.173, 0.446, 0.557 }, { 0.129, 0.565, 0.552 },
  { 0.153, 0.678, 0.506 }, { 0.361, 0.784, 0.388 }, { 0.667, 0.863, 0.196 },
  { 0.993, 0.906, 0.144 } };

std::array<double, 3> GetViridis(double t)
{
  const double place = t * (NumberOfAnchors - 1);
  const int first = std::min(static_cast<int>(place), NumberOfAnchors - 2);
  std::array<double, 3> color;
  for (int c = 0; c < 3; ++c)
  {
    color[c] = Viridis[first][c] + (place - first) * (Viridis[first + 1][c] - Viridis[first][c]);
  }
  return color;
}

// Return distinct colours for successive indices: hues by the golden ratio, in three tones.
std::array<double, 3> GetCategory(int i)
{
  constexpr double tones[3][2] = { { 0.65, 0.90 }, { 0.40, 0.98 }, { 0.80, 0.60 } };
  const double hue = 0.6180339887 * i - std::floor(0.6180339887 * i);
  const double* tone = tones[i % 3];
  std::array<double, 3> color;
  vtkMath::HSVToRGB(hue, tone[0], tone[1], &color[0], &color[1], &color[2]);
  return color;
}

void SetColor(vtkLookupTable* table, int i, const std::array<double, 3>& color)
{
  table->SetTableValue(i, color[0], color[1], color[2], 1.0);
}

// Return the name in the pattern table: by levels or, for whole numbers of segments, by segments.
std::string GetName(const SegmentSteps& steps, int i, int j, int k)
{
  const auto number = [&steps](int step)
  { return std::to_string(steps.AreWholeNumbers() ? steps.GetSegments(step) : step); };
  return "[" + number(i) + ", " + number(j) + ", " + number(k) + "]";
}
}

RefinementLevelTable::RefinementLevelTable() = default;
RefinementLevelTable::~RefinementLevelTable() = default;

int RefinementLevelTable::GetLevel(int segments)
{
  int level = 0;
  while (1 << level < segments)
  {
    ++level;
  }
  return level;
}

double RefinementLevelTable::GetValue(int mode, bool wholeNumbers, const RefinementPattern& pattern)
{
  std::array<int, 3> segments;
  std::copy_n(pattern.Segments, 3, segments.begin());
  std::sort(segments.rbegin(), segments.rend());
  if (mode != COLOR_BY_PATTERN)
  {
    return GetLevel(segments[0]);
  }
  const SegmentSteps steps = SegmentSteps::Make(wholeNumbers);
  return vtkRefinementPatternTable::GetPatternIndex(
    steps.FindStep(segments[0]), steps.FindStep(segments[1]), steps.FindStep(segments[2]));
}

vtkLookupTable* RefinementLevelTable::Get(int mode, bool wholeNumbers, int maximumLevel)
{
  if (this->TableDependencies.Update(Dependencies::On(mode, wholeNumbers, maximumLevel)))
  {
    this->Table->ResetAnnotations();
    this->Table->SetIndexedLookup(mode != COLOR_BY_METRIC);
    switch (mode)
    {
      case COLOR_BY_PATTERN:
        this->MakePatterns(SegmentSteps::Make(wholeNumbers), maximumLevel);
        break;
      case COLOR_BY_METRIC:
        this->MakeTags(maximumLevel);
        break;
      default:
        this->MakeLevels(maximumLevel);
    }
  }
  return this->Table;
}

void RefinementLevelTable::MakeLevels(int maximumLevel)
{
  this->Table->SetNumberOfTableValues(maximumLevel + 1);
  this->Table->SetTableRange(0.0, std::max(maximumLevel, 1));
  for (int level = 0; level <= maximumLevel; ++level)
  {
    SetColor(
      this->Table, level, GetViridis(static_cast<double>(level) / std::max(maximumLevel, 1)));
    this->Table->SetAnnotation(level, std::to_string(level));
  }
}

void RefinementLevelTable::MakePatterns(const SegmentSteps& steps, int maximumLevel)
{
  const int last = steps.FindStep(1 << maximumLevel);
  const int count = vtkRefinementPatternTable::GetPatternIndex(last, last, last) + 1;
  this->Table->SetNumberOfTableValues(count);
  this->Table->SetTableRange(0.0, std::max(count - 1, 1));
  for (int i = 0, index = 0; i <= last; ++i)
  {
    for (int j = 0; j <= i; ++j)
    {
      for (int k = 0; k <= j; ++k, ++index)
      {
        SetColor(this->Table, index, GetCategory(index));
        this->Table->SetAnnotation(index, GetName(steps, i, j, k));
      }
    }
  }
}

void RefinementLevelTable::MakeTags(int maximumLevel)
{
  constexpr int count = 256;
  this->Table->SetNumberOfTableValues(count);
  this->Table->SetTableRange(0.0, std::max(maximumLevel, 1));
  for (int i = 0; i < count; ++i)
  {
    SetColor(this->Table, i, GetViridis(i / (count - 1.0)));
  }
}
}
