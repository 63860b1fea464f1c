// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Patterns/TriangleSplit.h"

#include "Mathematics/RefinementMathematics.h"

#include <cstddef>

namespace relevo
{
#include "glsl/relevoSplit.glsl"

const TriangleSplit::Counts& TriangleSplit::Count(const Levels& left)
{
  const auto found = this->Known.find(left);
  if (found != this->Known.end())
  {
    return found->second;
  }
  Counts counts;
  const ivec3 levels(left[0], left[1], left[2]);
  if (levels == ivec3(0))
  {
    counts.fill(1);
  }
  else
  {
    counts.fill(0);
    counts[0] = 1;
    for (int part = 0; part < splitCount(levels); ++part)
    {
      const ivec3 rest = splitPart(levels, part).Left;
      const Counts& parts = this->Count({ { rest.x, rest.y, rest.z } });
      for (std::size_t step = 1; step < counts.size(); ++step)
      {
        counts[step] += parts[step - 1];
      }
    }
  }
  return this->Known[left] = counts;
}
}
