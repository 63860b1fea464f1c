// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Patterns/SegmentSteps.h"

#include "Patterns/CanonicalOrder.h"
#include "Patterns/PatternBorder.h"

#include <algorithm>
#include <cmath>

namespace relevo
{
namespace
{
constexpr int SmallSegments = 16; // all whole numbers up to this are steps
}

SegmentSteps SegmentSteps::MakePowersOfTwo(int highestLevel)
{
  SegmentSteps steps;
  for (int level = 0; level <= highestLevel; ++level)
  {
    steps.Segments.push_back(1 << level);
  }
  return steps;
}

SegmentSteps SegmentSteps::MakeWholeNumbers()
{
  SegmentSteps steps;
  steps.Whole = true;
  for (int n = 1; n <= SmallSegments; ++n)
  {
    steps.Segments.push_back(n);
  }
  for (int factor = 2; SmallSegments * factor <= MaximumNumberOfSegments; factor *= 2)
  {
    for (int n = SmallSegments / 2 + 1; n <= SmallSegments; ++n)
    {
      steps.Segments.push_back(n * factor);
    }
  }
  return steps;
}

SegmentSteps SegmentSteps::Make(bool wholeNumbers)
{
  return wholeNumbers ? MakeWholeNumbers() : MakePowersOfTwo(HighestLevel);
}

int SegmentSteps::FindStep(int segments) const
{
  const auto found = std::lower_bound(this->Segments.begin(), this->Segments.end() - 1, segments);
  return static_cast<int>(found - this->Segments.begin());
}

int SegmentSteps::GetWholeNumberStep(float tag)
{
  const int doublings = std::max(static_cast<int>(std::ceil(tag)) - 4, 0);
  const int multiple =
    static_cast<int>(std::floor(std::exp2(tag - static_cast<float>(doublings)) + 0.5f));
  return SmallSegments / 2 * doublings + multiple - 1;
}
}
