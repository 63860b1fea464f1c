// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Rays/ScalarBlending.h"

namespace relevo
{
namespace
{
dvec4 Show(const TransferFunctions& functions, const Scalars& scalars)
{
  const dvec4 color = functions.Map(scalars);
  return dvec4(dvec3(color) * color.w, color.w);
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
  Scalars extreme = parts.front().Front;
  const auto add = [&](const Scalars& scalars)
  {
    if (!functions.AreIndependent())
    {
      extreme = sign * scalars[last] > sign * extreme[last] ? scalars : extreme;
      return;
    }
    for (size_t c = 0; c <= last; ++c)
    {
      extreme[c] = sign * scalars[c] > sign * extreme[c] ? scalars[c] : extreme[c];
    }
  };
  for (const RayPart& part : parts)
  {
    add(part.Front);
    add(part.Back);
  }
  return Show(functions, extreme);
}

dvec4 BlendAverage(const TransferFunctions& functions, const std::vector<RayPart>& parts)
{
  Scalars sum = {};
  double length = 0.0;
  for (const RayPart& part : parts)
  {
    const Scalars mean = Interpolate(part.Front, part.Back, 0.5);
    for (size_t c = 0; c < sum.size(); ++c)
    {
      sum[c] += (part.End - part.Begin) * mean[c];
    }
    length += part.End - part.Begin;
  }
  if (length == 0.0)
  {
    return dvec4(0.0);
  }
  for (double& scalar : sum)
  {
    scalar /= length;
  }
  return Show(functions, sum);
}
}
