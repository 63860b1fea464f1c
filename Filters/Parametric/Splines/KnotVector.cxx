// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Splines/KnotVector.h"

#include <algorithm>
#include <cmath>
#include <locale>
#include <sstream>

namespace relevo
{
std::string FindKnotError(const std::vector<double>& knots, int degree, std::size_t points)
{
  std::ostringstream error;
  error.imbue(std::locale::classic());
  const auto order = static_cast<std::size_t>(degree) + 1;
  if (knots.size() != points + order)
  {
    error << "there are " << knots.size() << ", but " << points << " control points of degree "
          << degree << " need " << points + order << ".";
    return error.str();
  }
  for (std::size_t i = 0; i < knots.size(); ++i)
  {
    if (!std::isfinite(knots[i]) || !std::isfinite(knots[i] - knots.front()))
    {
      error << "knot " << i << " is " << knots[i] << ", but knots must be finite.";
      return error.str();
    }
    if (i > 0 && knots[i] < knots[i - 1])
    {
      error << "knots must not decrease, but knot " << i << " is " << knots[i] << ", after "
            << knots[i - 1] << ".";
      return error.str();
    }
    if (i >= order && knots[i] == knots[i - order])
    {
      error << "the knot " << knots[i] << " occurs more than " << order << " times.";
      return error.str();
    }
  }
  if (knots[degree] == knots[points])
  {
    error << "knot " << degree << " and knot " << points
          << " are equal, so that the curve has no length.";
  }
  return error.str();
}

std::vector<int> FindSpans(const std::vector<double>& knots, int degree)
{
  std::vector<int> spans;
  const int end = static_cast<int>(knots.size()) - degree - 1;
  for (int k = degree; k < end; ++k)
  {
    if (knots[k] < knots[k + 1])
    {
      spans.push_back(k);
    }
  }
  return spans;
}
}
