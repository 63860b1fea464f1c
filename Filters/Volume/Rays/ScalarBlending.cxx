// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Rays/ScalarBlending.h"

#include <algorithm>
#include <cmath>

namespace relevo
{
namespace
{
// Relative to the largest value on the ray: the rounding error between adjacent cells.
constexpr double ValueRounding = 1e-12;

// The values at a position, or their mean.
struct Sample
{
  Scalars Values;
  Scalars Steepness;

  dvec4 Show(const TransferFunctions& functions) const
  {
    const dvec4 color = functions.Map(this->Values, this->Steepness);
    return dvec4(dvec3(color) * color.w, color.w);
  }
};

Scalars FindSizes(const std::vector<RayPart>& parts)
{
  Scalars sizes = {};
  for (const RayPart& part : parts)
  {
    for (size_t c = 0; c < sizes.size(); ++c)
    {
      sizes[c] = std::max({ sizes[c], std::abs(part.Front[c]), std::abs(part.Back[c]) });
    }
  }
  return sizes;
}
}

dvec4 BlendExtreme(
  const TransferFunctions& functions, const std::vector<RayPart>& parts, double sign)
{
  if (parts.empty())
  {
    return dvec4(0.0);
  }
  const size_t last = static_cast<size_t>(functions.GetNumberOfComponents()) - 1;
  Sample extreme = { parts.front().Front, parts.front().Steepness };
  const Scalars sizes = FindSizes(parts);
  const auto add = [&](const Sample& sample)
  {
    for (size_t c = 0; c <= last; ++c)
    {
      const size_t deciding = functions.AreIndependent() ? c : last;
      const double farther = sign * (sample.Values[deciding] - extreme.Values[deciding]);
      if (farther > 0.0 && !functions.AreIndependent())
      {
        extreme = sample;
      }
      else if (farther > 0.0)
      {
        // On a face, the gradient of the first of the two cells is used.
        const bool isElsewhere = farther > ValueRounding * sizes[c];
        extreme.Values[c] = sample.Values[c];
        extreme.Steepness[c] = isElsewhere ? sample.Steepness[c] : extreme.Steepness[c];
      }
    }
  };
  for (const RayPart& part : parts)
  {
    add({ part.Front, part.Steepness });
    add({ part.Back, part.Steepness });
  }
  return extreme.Show(functions);
}

dvec4 BlendAverage(const TransferFunctions& functions, const std::vector<RayPart>& parts)
{
  Sample mean = {};
  double length = 0.0;
  for (const RayPart& part : parts)
  {
    const Scalars middle = Interpolate(part.Front, part.Back, 0.5);
    const double here = part.End - part.Begin;
    length += here;
    for (size_t c = 0; c < middle.size(); ++c)
    {
      mean.Values[c] += here * middle[c];
      mean.Steepness[c] += here * part.Steepness[c];
    }
  }
  if (length == 0.0)
  {
    return dvec4(0.0);
  }
  for (size_t c = 0; c < mean.Values.size(); ++c)
  {
    mean.Values[c] /= length;
    mean.Steepness[c] /= length;
  }
  return mean.Show(functions);
}
}
