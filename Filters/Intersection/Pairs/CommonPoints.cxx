// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Pairs/CommonPoints.h"

namespace relevo
{
TrianglePart FindPart(const std::array<int, 3>& sides)
{
  // Indexed by the set of edges whose lines contain the point. No point is on all three.
  static constexpr TrianglePart parts[8] = { Interior, 3, 4, 1, 5, 0, 2, Outside };
  int on = 0;
  for (int i = 0; i < 3; ++i)
  {
    if (sides[i] < 0)
    {
      return Outside;
    }
    on |= (sides[i] == 0) << i;
  }
  return parts[on];
}
}
