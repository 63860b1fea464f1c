// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Boxes/BoxSegment.h"

#include <algorithm>
#include <limits>

namespace relevo
{
BoxSegment::BoxSegment(const double start[3], const double end[3], double margin)
  : Margin(margin)
{
  for (int c = 0; c < 3; ++c)
  {
    this->Start[c] = start[c];
    this->Still[c] = end[c] == start[c];
    this->Inverse[c] = this->Still[c] ? 0.0 : 1.0 / (end[c] - start[c]);
  }
}

double BoxSegment::GetEntry(const BoundingBox<float>& box, double last) const
{
  const double never = std::numeric_limits<double>::infinity();
  double entry = 0.0;
  double exit = last;
  for (int c = 0; c < 3; ++c)
  {
    const double low = box.Low[c] - this->Margin - this->Start[c];
    const double high = box.High[c] + this->Margin - this->Start[c];
    if (this->Still[c])
    {
      if (low > 0.0 || high < 0.0)
      {
        return never;
      }
      continue;
    }
    const double a = low * this->Inverse[c];
    const double b = high * this->Inverse[c];
    entry = std::max(entry, std::min(a, b));
    // A rounded quotient must not miss the box.
    exit = std::min(exit, std::max(a, b) * (1.0 + 8.0 * std::numeric_limits<double>::epsilon()));
  }
  return entry <= exit ? entry : never;
}
}
