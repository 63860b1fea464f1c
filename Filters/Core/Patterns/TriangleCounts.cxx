// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Patterns/TriangleCounts.h"

#include "Patterns/PatternFamily.h"
#include "Patterns/RefinementPattern.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace relevo
{
namespace
{
// The number of triangles of a pattern. It is exact for equal segments and otherwise mostly within
// 20 %. Sums over many faces are within 10 %.
int EstimateTriangles(int a, int b, int c)
{
  const double mean = (a + b + c) / 3.0;
  return static_cast<int>(std::lround(mean * mean));
}

std::vector<float> MakeMinimumTags(const SegmentSteps& steps, int maximumLevel)
{
  std::vector<float> tags = { -std::numeric_limits<float>::infinity() };
  for (int step = 1;
       step < steps.GetNumberOfSteps() && steps.GetSegments(step) <= 1 << maximumLevel; ++step)
  {
    const double low = steps.GetSegments(step - 1);
    const double high = steps.GetSegments(step);
    // For powers of two, the level is rounded; for whole numbers, the number of segments is.
    tags.push_back(static_cast<float>(
      steps.AreWholeNumbers() ? std::log2(0.5 * (low + high)) : 0.5 * std::log2(low * high)));
  }
  tags.push_back(std::numeric_limits<float>::infinity());
  return tags;
}
}

TriangleCounts::TriangleCounts(const PatternFamily& family, int maximumLevel)
  : Estimates(family.AreWholeNumbers())
  , MinimumTags(MakeMinimumTags(family.GetSegmentSteps(), maximumLevel))
{
  const SegmentSteps& steps = family.GetSegmentSteps();
  const int n = this->GetNumberOfSteps();
  this->Triangles.resize(static_cast<size_t>(n) * n * n);
  vtkSMPTools::For(0, static_cast<vtkIdType>(this->Triangles.size()), 1,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        const int a = static_cast<int>(i / n / n);
        const int b = static_cast<int>(i / n % n);
        const int c = static_cast<int>(i % n);
        this->Triangles[i] = this->Estimates
          ? EstimateTriangles(steps.GetSegments(a), steps.GetSegments(b), steps.GetSegments(c))
          : family.GetPattern(static_cast<int>(family.GetEntry(0, a, b, c) >> 3))
              ->GetNumberOfTriangles();
      }
    });

  // Propagate the maximum of lower steps, one edge after the other.
  for (const int stride : { 1, n, n * n })
  {
    for (int i = 0; i < static_cast<int>(this->Triangles.size()); ++i)
    {
      if (i / stride % n > 0)
      {
        this->Triangles[i] = std::max(this->Triangles[i], this->Triangles[i - stride]);
      }
    }
  }
}
}
