// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Patterns/PatternFamily.h"

#include "Core/CornerOrder.h"
#include "Patterns/NestedPattern.h"
#include "vtkRefinementPatternTable.h"

#include <algorithm>
#include <cmath>

namespace relevo
{
namespace
{
constexpr int Levels = vtkRefinementPatternTable::HighestLevel + 1;
constexpr int SmallSegments = 16; // up to here every whole number

std::vector<int> GetDyadicSegments()
{
  std::vector<int> segments;
  for (int level = 0; level < Levels; ++level)
  {
    segments.push_back(1 << level);
  }
  return segments;
}

std::vector<int> GetWholeSegments()
{
  std::vector<int> segments;
  for (int n = 1; n <= SmallSegments; ++n)
  {
    segments.push_back(n);
  }
  for (int factor = 2; SmallSegments * factor <= 1 << vtkRefinementPatternTable::HighestLevel;
       factor *= 2)
  {
    for (int n = SmallSegments / 2 + 1; n <= SmallSegments; ++n)
    {
      segments.push_back(n * factor);
    }
  }
  return segments;
}

// Key and permutation code of canonical patterns.
unsigned int MakeCanonicalEntry(int order, int step01, int step12, int step02)
{
  // Sorted corner j is the cell's corner corners[j]; the edge that lacks sorted corner j is known
  // by its step lacking[j], and the cell's edge i lacks its corner i + 2.
  const auto& corners = GetCornerOrder(order);
  const int lacking[3] = { step12, step02, step01 };
  int steps[3];
  for (int j = 0; j < 3; ++j)
  {
    steps[(corners[j] + 1) % 3] = lacking[j];
  }
  const int lambda = vtkRefinementPatternTable::Canonicalize(steps);
  int permutation[3];
  vtkRefinementPatternTable::GetPermutation(lambda, permutation);
  const int pattern = vtkRefinementPatternTable::GetPatternIndex(steps[0], steps[1], steps[2]);
  const int key = 2 * pattern + (vtkRefinementPatternTable::IsOdd(lambda) ? 1 : 0);
  return static_cast<unsigned int>(key << 3 |
    GetCornerOrderCode(permutation[corners[0]], permutation[corners[1]], permutation[corners[2]]));
}
}

const PatternFamily& PatternFamily::GetPowersOfTwo()
{
  static const PatternFamily family(GetDyadicSegments(), false, false);
  return family;
}

const PatternFamily& PatternFamily::GetWholeNumbers()
{
  static const PatternFamily family(GetWholeSegments(), false, true);
  return family;
}

const PatternFamily& PatternFamily::GetNested()
{
  static const PatternFamily family(GetDyadicSegments(), true, false);
  return family;
}

PatternFamily::PatternFamily(std::vector<int> segments, bool morphing, bool whole)
  : Segments(std::move(segments))
  , Morphing(morphing)
  , Whole(whole)
{
  const int n = this->GetNumberOfSteps();
  auto addKeys = [this](int i, int j, int k)
  {
    this->Keys.insert(this->Keys.end(), 2,
      { { static_cast<unsigned char>(i), static_cast<unsigned char>(j),
        static_cast<unsigned char>(k) } });
  };
  for (int i = 0; i < n; ++i)
  {
    for (int j = 0; j < (morphing ? n : i + 1); ++j)
    {
      for (int k = 0; k < (morphing ? n : j + 1); ++k)
      {
        addKeys(i, j, k);
      }
    }
  }
  this->Entries.reserve(static_cast<size_t>(6 * n * n * n));
  for (int order = 0; order < 6; ++order)
  {
    const int odd = order & 1; // permutation codes 1, 3 and 5 mirror
    for (int a = 0; a < n; ++a)
    {
      for (int b = 0; b < n; ++b)
      {
        for (int c = 0; c < n; ++c)
        {
          this->Entries.push_back(morphing
              ? static_cast<unsigned int>(2 * ((a * n + b) * n + c) + odd) << 3
              : MakeCanonicalEntry(order, a, b, c));
        }
      }
    }
  }
}

int PatternFamily::GetWholeNumberStep(float tag)
{
  const int doublings = std::max(static_cast<int>(std::ceil(tag)) - 4, 0);
  const int multiple =
    static_cast<int>(std::floor(std::exp2(tag - static_cast<float>(doublings)) + 0.5f));
  return SmallSegments / 2 * doublings + multiple - 1;
}

std::shared_ptr<const RefinementPattern> PatternFamily::GetPattern(
  int key, vtkRefinementPatternTable* table) const
{
  const auto& steps = this->Keys[key];
  if (this->Morphing)
  {
    // No owner: these live as long as the program.
    return { std::shared_ptr<void>(), &GetNestedPattern(steps[0], steps[1], steps[2]) };
  }
  return table->GetPatternOfSegments(
    this->Segments[steps[0]], this->Segments[steps[1]], this->Segments[steps[2]]);
}
}
