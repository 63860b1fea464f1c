// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves guide.md on geomorphing with nested patterns: all 512 patterns are exact triangulations,
// no tags flip a triangle, and faces compute the points of an edge bit for bit alike. The surface
// is continuous where levels change; a pattern whose vertices do not move is the negative control.
#include "RelevoCheck.h"
#include "RelevoPatternCheck.h"

#include "Patterns/FacePattern.h"
#include "Patterns/PatternFamily.h"
#include "Patterns/PatternLibrary.h"
#include "Patterns/RefinementPattern.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <random>
#include <set>
#include <thread>
#include <vector>

namespace
{
using namespace RelevoPatternCheck;
using Tags = std::array<float, 3>;
using Levels = std::array<int, 3>;

constexpr int Highest = 7;

template <typename Visitor>
void ForEachLevels(int maximumLevel, Visitor&& visit)
{
  for (int i = 0; i <= maximumLevel; ++i)
  {
    for (int j = 0; j <= maximumLevel; ++j)
    {
      for (int k = 0; k <= maximumLevel; ++k)
      {
        visit(Levels{ i, j, k });
      }
    }
  }
}

// All patterns of this test come from one library.
const relevo::PatternLibrary& GetLibrary()
{
  static const relevo::PatternLibrary library;
  return library;
}

const relevo::RefinementPattern& GetPattern(const Levels& levels)
{
  const auto family = GetLibrary().GetFamily(relevo::PatternLibrary::NESTED);
  const unsigned int entry = family->GetEntry(0, levels[0], levels[1], levels[2]);
  return *family->GetPattern(static_cast<int>(entry >> 3));
}

Levels Round(const Tags& tags, int maximumLevel)
{
  Levels levels;
  for (int e = 0; e < 3; ++e)
  {
    const double rounded = std::floor(static_cast<double>(tags[e]) + 0.5);
    levels[e] = static_cast<int>(std::clamp<double>(rounded, 0.0, maximumLevel));
  }
  return levels;
}

// The vertices of a pattern for some tags, in the plane of (v, w).
struct Sheet
{
  Sheet(const Tags& tags, int maximumLevel)
    : Sheet(tags, maximumLevel, Round(tags, maximumLevel))
  {
  }

  // The levels are a parameter so that compilers do not treat the pattern as part of a temporary.
  Sheet(const Tags& tags, int maximumLevel, const Levels& levels)
    : Pattern(GetPattern(levels))
  {
    float clamped[3];
    for (int e = 0; e < 3; ++e)
    {
      const auto last = static_cast<float>(maximumLevel);
      clamped[e] = std::clamp(tags[e], 0.0f, last);
      clamped[e] += std::max(clamped[e] - (last - 0.5f), 0.0f); // complete at the last level
    }
    const relevo::FacePattern facePattern{ &this->Pattern, 0, false, clamped };
    this->Weights.resize(this->Pattern.Vertices.size());
    for (int vertex = 0; vertex < this->Pattern.GetNumberOfVertices(); ++vertex)
    {
      facePattern.GetWeights(vertex, &this->Weights[3 * static_cast<size_t>(vertex)]);
    }
  }

  Triple GetWeights(unsigned int vertex) const
  {
    const float* w = &this->Weights[3 * vertex];
    return { w[0], w[1], w[2] };
  }

  const relevo::RefinementPattern& Pattern;
  std::vector<float> Weights;
};

// A function on the face that is curved everywhere.
double Height(const Triple& p)
{
  return std::sin(3.0 * p[1] + 1.0) * std::cos(2.0 * p[2]) + p[1] * p[2];
}

// Piecewise linear interpolation of Height() at a point.
double Interpolate(const Sheet& sheet, const Triple& point)
{
  double best = -1.0;
  double height = 0.0;
  const auto& triangles = sheet.Pattern.Triangles;
  for (std::size_t t = 0; t < triangles.size() && best < 0.0; t += 3)
  {
    const Triple a = sheet.GetWeights(triangles[t]);
    const Triple b = sheet.GetWeights(triangles[t + 1]);
    const Triple c = sheet.GetWeights(triangles[t + 2]);
    const double area = Area(a, b, c);
    if (area < 1e-10)
    {
      continue;
    }
    const double w[3] = { Area(point, b, c) / area, Area(a, point, c) / area,
      Area(a, b, point) / area };
    const double lowest = *std::min_element(w, w + 3);
    if (lowest > best)
    {
      best = lowest;
      height = w[0] * Height(a) + w[1] * Height(b) + w[2] * Height(c);
    }
  }
  return height;
}

// Largest difference between two surfaces at random points of the face.
double Distance(const Sheet& one, const Sheet& other, int numberOfPoints, std::mt19937& random)
{
  std::uniform_real_distribution<float> any(0.0f, 1.0f);
  double distance = 0.0;
  for (int i = 0; i < numberOfPoints; ++i)
  {
    float v = any(random);
    float w = any(random);
    if (v + w > 1.0f)
    {
      v = 1.0f - v;
      w = 1.0f - w;
    }
    const Triple point = { 1.0f - v - w, v, w };
    distance = std::max(distance, std::abs(Interpolate(one, point) - Interpolate(other, point)));
  }
  return distance;
}

void TestPatterns(RelevoCheck& check)
{
  ForEachLevels(Highest,
    [&](const Levels& levels)
    {
      const relevo::RefinementPattern& pattern = GetPattern(levels);
      for (int e = 0; e < 3; ++e)
      {
        CHECK(pattern.Segments[e] == 1 << levels[e]);
      }
      CheckVertices(check, pattern);
      CheckTriangles(check, pattern);
      const bool grid = std::all_of(pattern.Vertices.begin(), pattern.Vertices.end(),
        [](float weight) { return 128.0f * weight == std::floor(128.0f * weight); });
      CHECK(grid);
      if (levels[0] == levels[1] && levels[1] == levels[2])
      {
        const int regular = 1 << 2 * levels[0];
        CHECK_EQUAL(pattern.GetNumberOfTriangles(), (levels[0] == 1 ? 6 : regular));
      }
    });
}

void TestThreads(RelevoCheck& check)
{
  std::array<std::vector<const relevo::RefinementPattern*>, 4> found;
  std::vector<std::thread> threads;
  for (auto& patterns : found)
  {
    threads.emplace_back(
      [&patterns] {
        ForEachLevels(4, [&](const Levels& levels) { patterns.push_back(&GetPattern(levels)); });
      });
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
  for (const auto& patterns : found)
  {
    CHECK_EQUAL(patterns, found[0]);
  }
}

// A random tag of this level, sometimes close to its ends.
float RandomTag(int level, int maximumLevel, std::mt19937& random)
{
  std::uniform_real_distribution<float> any(0.0f, 1.0f);
  const float low = level == 0 ? 0.0f : static_cast<float>(level) - 0.5f;
  const float high = level == maximumLevel ? static_cast<float>(level)
                                           : std::nextafter(static_cast<float>(level) + 0.5f, 0.0f);
  switch (random() % 5)
  {
    case 0:
      return low;
    case 1:
      return high;
    case 2:
      return std::min(high, low + 0.05f * any(random) * any(random));
    default:
      return std::min(high, low + (high - low) * any(random));
  }
}

double ShortestSide(const Triple& a, const Triple& b, const Triple& c)
{
  auto distance = [](const Triple& p, const Triple& q)
  { return std::hypot(p[1] - q[1], p[2] - q[2]); };
  return std::min({ distance(a, b), distance(b, c), distance(c, a) });
}

// No triangle flips, and together they cover the face once. A triangle may be empty only if two
// corners coincide up to rounding; any other empty triangle would be a gap in a curved surface.
void CheckSheet(RelevoCheck& check, const Sheet& sheet)
{
  double area = 0.0;
  double lowest = 1.0;
  bool collapsed = true;
  const auto& triangles = sheet.Pattern.Triangles;
  for (std::size_t t = 0; t < triangles.size(); t += 3)
  {
    const Triple a = sheet.GetWeights(triangles[t]);
    const Triple b = sheet.GetWeights(triangles[t + 1]);
    const Triple c = sheet.GetWeights(triangles[t + 2]);
    const double triangleArea = Area(a, b, c);
    area += triangleArea;
    lowest = std::min(lowest, triangleArea);
    collapsed = collapsed && (triangleArea != 0.0 || ShortestSide(a, b, c) < 1e-3);
  }
  CHECK_GREATER(lowest, -1e-7);
  CHECK_NEAR(area, 1.0, 1e-5);
  CHECK(collapsed);
  const bool inside = std::all_of(sheet.Weights.begin(), sheet.Weights.end(),
    [](float weight) { return weight >= -1e-7f && weight <= 1.0f; });
  CHECK(inside);
}

void TestOrientation(RelevoCheck& check)
{
  std::mt19937 random(1);
  ForEachLevels(Highest,
    [&](const Levels& levels)
    {
      const int highest = *std::max_element(levels.begin(), levels.end());
      for (int i = 0; i < (highest > 4 ? 20 : 200); ++i)
      {
        const int maximumLevel = highest + static_cast<int>(random() % (Highest + 1 - highest));
        Tags tags;
        for (int e = 0; e < 3; ++e)
        {
          tags[e] = RandomTag(levels[e], maximumLevel, random);
        }
        CheckSheet(check, Sheet(tags, maximumLevel));
      }
    });
}

// When all levels are complete, vertices reach their final positions.
void TestArrival(RelevoCheck& check)
{
  for (int level = 0; level <= Highest; ++level)
  {
    for (const float tag : { static_cast<float>(level), 100.0f, HUGE_VALF })
    {
      const Sheet sheet({ tag, tag, tag }, level);
      if (level != 1) // has a vertex on another
      {
        CHECK_EQUAL(sheet.Weights, sheet.Pattern.Vertices);
      }
      else
      {
        std::set<Triple> places;
        for (int vertex = 0; vertex < sheet.Pattern.GetNumberOfVertices(); ++vertex)
        {
          places.insert(sheet.GetWeights(vertex));
        }
        CHECK_EQUAL(places.size(), 6);
      }
    }
  }
}

// Surfaces just below and just above level changes are close.
void TestContinuity(RelevoCheck& check)
{
  std::mt19937 random(2);
  std::uniform_real_distribution<float> any(0.0f, 1.0f);
  constexpr float Step = 0x1p-20f;
  double control = 0.0;
  for (int i = 0; i < 4000; ++i)
  {
    const int maximumLevel = i % 100 == 0 ? Highest : 1 + i % 5;
    const auto base = static_cast<float>(maximumLevel) * any(random);
    Tags before;
    Tags after;
    for (int e = 0; e < 3; ++e)
    {
      const float range = i % 2 ? static_cast<float>(maximumLevel) : 2.0f;
      float tag = std::max(base + range * (any(random) - 0.5f), 0.0f);
      if (random() % 2)
      {
        tag = std::floor(tag) + 0.5f;
      }
      before[e] = std::max(tag - Step, 0.0f);
      after[e] = tag + Step;
    }
    const Sheet one(before, maximumLevel);
    const Sheet other(after, maximumLevel);
    CHECK_LESS(Distance(one, other, 60, random), 100.0 * Step);

    Sheet still(before, maximumLevel);
    still.Weights = still.Pattern.Vertices;
    Sheet stillAfter(after, maximumLevel);
    stillAfter.Weights = stillAfter.Pattern.Vertices;
    control = std::max(control, Distance(still, stillAfter, 10, random));
  }
  CHECK_GREATER(control, 0.05);
}

// Weights of points on an edge depend only on the edge's tag, whichever edge of the face it is.
void TestSharedEdges(RelevoCheck& check)
{
  std::mt19937 random(3);
  for (int i = 0; i < 3000; ++i)
  {
    const int maximumLevel = 1 + i % Highest;
    const int level = static_cast<int>(random() % (maximumLevel + 1));
    const float tag = RandomTag(level, maximumLevel, random);
    std::vector<float> expected;
    for (int edge = 0; edge < 3; ++edge)
    {
      Tags tags;
      for (float& other : tags)
      {
        const int otherLevel = static_cast<int>(random() % (maximumLevel + 1));
        other = RandomTag(otherLevel, maximumLevel, random);
      }
      tags[edge] = tag;
      const Sheet sheet(tags, maximumLevel);
      std::vector<unsigned int> vertices = EdgeVertices(sheet.Pattern, edge);
      if (edge == 2) // leads from corner 2 to corner 0
      {
        std::reverse(vertices.begin(), vertices.end());
      }
      const std::size_t lower = edge == 1 ? 1 : 0;
      const std::size_t higher = edge == 0 ? 1 : 2;
      std::vector<float> weights;
      for (const unsigned int vertex : vertices)
      {
        const Triple w = sheet.GetWeights(vertex);
        weights.insert(weights.end(), { w[lower], w[higher] });
        CHECK_EQUAL(w[3 - lower - higher], 0.0f);
      }
      if (edge == 0)
      {
        expected = weights;
      }
      CHECK_EQUAL(weights.size(), expected.size());
      CHECK_EQUAL(std::memcmp(weights.data(), expected.data(), weights.size() * sizeof(float)), 0);
    }
  }
}
}

int TestNestedPatterns(int, char*[])
{
  RelevoCheck check;
  TestThreads(check);
  TestPatterns(check);
  TestOrientation(check);
  TestArrival(check);
  TestContinuity(check);
  TestSharedEdges(check);
  return check.GetResult();
}
