// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Splines/KnotVector.h"

#include <algorithm>
#include <cmath>
#include <locale>
#include <sstream>

namespace relevo
{
std::string FindKnotFault(const std::vector<double>& knots, int degree, std::size_t points)
{
  std::ostringstream fault;
  fault.imbue(std::locale::classic());
  const auto order = static_cast<std::size_t>(degree) + 1;
  if (knots.size() != points + order)
  {
    fault << "there are " << knots.size() << "; " << points << " control points of degree "
          << degree << " need " << points + order << ".";
    return fault.str();
  }
  for (std::size_t i = 0; i < knots.size(); ++i)
  {
    if (!std::isfinite(knots[i]) || !std::isfinite(knots[i] - knots.front()))
    {
      fault << "knot " << i << " is " << knots[i] << ", not finite.";
      return fault.str();
    }
    if (i > 0 && knots[i] < knots[i - 1])
    {
      fault << "knot " << i << " falls, from " << knots[i - 1] << " to " << knots[i] << ".";
      return fault.str();
    }
    if (i >= order && knots[i] == knots[i - order])
    {
      fault << "the knot " << knots[i] << " is there more than " << order << " times.";
      return fault.str();
    }
  }
  if (knots[degree] == knots[points])
  {
    fault << "nothing lies between knot " << degree << " and knot " << points << ".";
  }
  return fault.str();
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
