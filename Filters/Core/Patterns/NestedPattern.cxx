// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Patterns/NestedPattern.h"

#include "Patterns/NestedPatternMesh.h"
#include "Patterns/RefinementPatternGenerator.h"

namespace relevo
{
RefinementPattern MakeNestedPattern(const std::array<int, 3>& levels)
{
  const int segments[3] = { 1 << levels[0], 1 << levels[1], 1 << levels[2] };
  return MakePattern(segments, MakeNestedMesh(levels));
}
}
