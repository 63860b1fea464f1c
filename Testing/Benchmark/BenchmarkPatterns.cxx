// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Measures the triangles into which methods split a face whose edges have different levels.
#include "BenchmarkMeasure.h"
#include "BenchmarkReport.h"
#include "Benchmarks.h"

#include "RelevoPatternQuality.h"

#include "Mathematics/RefinementMathematics.h"
#include "vtkNew.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

namespace relevo
{
#include "glsl/relevoSplit.glsl"
}

namespace
{
constexpr int HighestLevel = 5;

using RelevoPatternQuality::Shape;

using Place = std::array<float, 3>;

// DMR's triangles with separate corners.
class SplitPattern
{
public:
  explicit SplitPattern(const int levels[3])
  {
    this->Split(
      { { { { 1.0f, 0.0f, 0.0f } }, { { 0.0f, 1.0f, 0.0f } }, { { 0.0f, 0.0f, 1.0f } } } },
      { levels[0], levels[1], levels[2] });
  }
  const relevo::RefinementPattern& Get() const { return this->Pattern; }

private:
  void Split(const std::array<Place, 3>& corners, const relevo::ivec3& left)
  {
    if (left == relevo::ivec3(0))
    {
      for (const Place& corner : corners)
      {
        this->Pattern.Triangles.push_back(
          static_cast<unsigned int>(this->Pattern.GetNumberOfVertices()));
        this->Pattern.Vertices.insert(this->Pattern.Vertices.end(), corner.begin(), corner.end());
      }
      return;
    }
    for (int i = 0; i < relevo::splitCount(left); ++i)
    {
      const relevo::SplitPart part = relevo::splitPart(left, i);
      std::array<Place, 3> parts;
      for (int k = 0; k < 3; ++k)
      {
        const int first = part.Corners[k] % 3;
        const Place& a = corners[first];
        const Place& b = part.Corners[k] < 3 ? a : corners[(first + 1) % 3];
        parts[k] = { { 0.5f * (a[0] + b[0]), 0.5f * (a[1] + b[1]), 0.5f * (a[2] + b[2]) } };
      }
      this->Split(parts, part.Left);
    }
  }

  relevo::RefinementPattern Pattern;
};

// Over all patterns with the same difference between highest and lowest level.
struct Statistics
{
  int Patterns = 0;
  int Triangles = 0;
  int Degenerate = 0;
  double SmallestAngle = 180.0;
  std::vector<double> BorderAngles;  // smallest angle of each triangle at the border
  std::vector<double> BorderAspects; // its longest side over its smallest height
  std::vector<double> Steps;         // larger over smaller area across each inner side
};

void Add(const relevo::RefinementPattern& pattern, Statistics& statistics)
{
  const std::vector<Shape> shapes = RelevoPatternQuality::GetShapes(pattern);
  ++statistics.Patterns;
  statistics.Triangles += static_cast<int>(shapes.size());
  // Sides by the positions of their ends, because snapped vertices coincide.
  std::map<std::pair<Place, Place>, double> areas;
  for (size_t t = 0; t < shapes.size(); ++t)
  {
    if (shapes[t].IsDegenerate())
    {
      ++statistics.Degenerate;
      continue;
    }
    Place places[3];
    bool touchesBorder = false;
    for (int i = 0; i < 3; ++i)
    {
      const float* weights = &pattern.Vertices[3 * pattern.Triangles[3 * t + i]];
      std::copy_n(weights, 3, places[i].begin());
      touchesBorder = touchesBorder || *std::min_element(weights, weights + 3) == 0.0f;
    }
    statistics.SmallestAngle = std::min(statistics.SmallestAngle, shapes[t].SmallestAngle);
    if (touchesBorder)
    {
      statistics.BorderAngles.push_back(shapes[t].SmallestAngle);
      statistics.BorderAspects.push_back(shapes[t].Aspect);
    }
    for (int i = 0; i < 3; ++i)
    {
      const std::pair<Place, Place> side = std::minmax(places[i], places[(i + 1) % 3]);
      const auto other = areas.emplace(side, shapes[t].Area);
      if (!other.second)
      {
        const double ratio = shapes[t].Area / other.first->second;
        statistics.Steps.push_back(std::max(ratio, 1.0 / ratio));
      }
    }
  }
}

double GetMean(const std::vector<double>& values)
{
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double GetLargest(const std::vector<double>& values)
{
  return *std::max_element(values.begin(), values.end());
}

// Share of the values below a bound, in percent.
double GetShareBelow(const std::vector<double>& values, double bound)
{
  return 100.0 *
    static_cast<double>(std::count_if(
      values.begin(), values.end(), [bound](double value) { return value < bound; })) /
    static_cast<double>(values.size());
}

void AddRow(
  const std::string& method, int difference, const Statistics& statistics, BenchmarkTable& table)
{
  table.AddRow({ method, static_cast<double>(difference), static_cast<double>(statistics.Patterns),
    static_cast<double>(statistics.Triangles) / statistics.Patterns,
    100.0 * statistics.Degenerate / statistics.Triangles, statistics.SmallestAngle,
    GetMean(statistics.BorderAngles), GetShareBelow(statistics.BorderAngles, 10.0),
    GetShareBelow(statistics.BorderAngles, 20.0), GetMean(statistics.BorderAspects),
    GetLargest(statistics.BorderAspects), GetMean(statistics.Steps),
    GetLargest(statistics.Steps) });
}
}

void RunPatterns(const BenchmarkOptions&, const AddTable& addTable)
{
  BenchmarkTable table("quality-patterns", "Transitions: triangles where levels differ",
    { { "method", "method", 0 }, { "difference", "levels differ by", 0 },
      { "patterns", "patterns", 0 }, { "triangles", "triangles, mean", 1 },
      { "degenerate_percent", "degenerate, %", 1 }, { "smallest_angle", "smallest angle, °", 1 },
      { "border_angle", "at borders: mean of smallest, °", 1 },
      { "border_below_10_percent", "below 10°, %", 1 },
      { "border_below_20_percent", "below 20°, %", 1 }, { "border_aspect", "aspect, mean", 2 },
      { "border_aspect_largest", "largest", 1 }, { "step", "area to the neighbour's, mean", 2 },
      { "step_largest", "largest", 1 } });
  vtkNew<vtkRefinementPatternTable> patterns;
  std::array<std::array<Statistics, HighestLevel + 1>, 3> statistics;
  for (int i = 0; i <= HighestLevel; ++i)
  {
    for (int j = 0; j <= i; ++j)
    {
      for (int k = 0; k <= j; ++k)
      {
        const int levels[3] = { i, j, k };
        if (i > 0) // the unsplit triangle says nothing about a method
        {
          Add(*patterns->GetPatternOfSegments(1 << i, 1 << j, 1 << k), statistics[0][i - k]);
          Add(RelevoPatternQuality::MakeSuaptPattern(patterns, levels), statistics[1][i - k]);
          Add(SplitPattern(levels).Get(), statistics[2][i - k]);
        }
      }
    }
  }
  for (int difference = 0; difference <= HighestLevel; ++difference)
  {
    AddRow("ARKFPI", difference, statistics[0][difference], table);
    AddRow("SUAPT", difference, statistics[1][difference], table);
    AddRow("DMR", difference, statistics[2][difference], table);
  }
  table.AddNote("All levels of three edges up to 5, in the equilateral triangle. Angles, aspects "
                "(longest side to smallest height, 1.15 at best) and areas leave out degenerate "
                "triangles; at borders: those with a vertex on an edge.");
  addTable(table);
}
