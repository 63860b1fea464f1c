// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Integral/FillValues.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace relevo
{
namespace
{
constexpr double LeastFillValue = 1e15;
constexpr double LeastGap = 1e6;

// Returns the largest finite magnitude below a limit, or 0.
double FindLargest(size_t count, const std::function<double(size_t)>& get, double limit)
{
  double largest = 0.0;
  for (size_t i = 0; i < count; ++i)
  {
    const double magnitude = std::abs(get(i));
    largest = magnitude < limit ? std::max(largest, magnitude) : largest;
  }
  return largest;
}
}

std::vector<double> FindFillValues(size_t count, const std::function<double(size_t)>& get)
{
  std::vector<double> found;
  double largest = FindLargest(count, get, std::numeric_limits<double>::infinity());
  while (largest >= LeastFillValue)
  {
    const double next = FindLargest(count, get, largest);
    if (next == 0.0 || largest / LeastGap < next)
    {
      break;
    }
    found.push_back(largest);
    largest = next;
  }
  return found;
}

bool IsMissing(double value, const std::vector<double>& fillValues)
{
  return !std::isfinite(value) ||
    std::find(fillValues.begin(), fillValues.end(), std::abs(value)) != fillValues.end();
}
}
