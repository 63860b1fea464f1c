// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Rays/OpacityDepth.h"

namespace relevo
{
namespace
{
// Halvings of a segment, to the rounding of double precision.
constexpr int NumberOfHalvings = 52;
}

bool OpacityDepth::Find(
  const std::vector<RayPart>& parts, double threshold, RayPosition& position) const
{
  switch (this->Mode)
  {
    case BlendMode::Maximum:
    case BlendMode::Minimum:
      return this->FindExtreme(parts, threshold, position);
    case BlendMode::Average:
      return false;
    default:
      return this->FindAlong(parts, threshold, position);
  }
}

// Returns the alpha behind a segment.
double OpacityDepth::Add(double alpha, const Segment& segment) const
{
  if (this->Mode == BlendMode::IsoSurface)
  {
    return alpha;
  }
  return this->Mode == BlendMode::Additive
    ? alpha + this->Functions.Sum(segment).w
    : alpha + (1.0 - alpha) * this->Functions.Integrate(segment).w;
}

bool OpacityDepth::FindAlong(
  const std::vector<RayPart>& parts, double threshold, RayPosition& position) const
{
  const std::vector<IsoCrossing> crossings =
    this->Mode == BlendMode::Additive ? std::vector<IsoCrossing>() : this->Surfaces.Cross(parts);
  auto crossing = crossings.begin();
  double alpha = 0.0;
  for (size_t i = 0; i < parts.size(); ++i)
  {
    const RayPart& part = parts[i];
    const Segment segment = { part.Front, part.Back, part.End - part.Begin, part.Steepness };
    double begin = 0.0;
    // Passes a segment that ends at a surface or at the end of the part.
    const auto pass = [&](double end)
    {
      const double before = alpha;
      const auto getAlpha = [&](double at) { return this->Add(before, segment.Cut(begin, at)); };
      alpha = getAlpha(end);
      if (alpha < threshold)
      {
        begin = end;
        return false;
      }
      double low = begin;
      double high = end;
      for (int k = 0; k < NumberOfHalvings && low < high; ++k)
      {
        const double middle = 0.5 * (low + high);
        (getAlpha(middle) < threshold ? low : high) = middle;
      }
      position = { i, high };
      return true;
    };
    for (; crossing != crossings.end() && crossing->Part == i; ++crossing)
    {
      if (pass(crossing->Share))
      {
        return true;
      }
      alpha += (1.0 - alpha) * this->Surfaces.GetColor(this->Functions, part, *crossing).w;
      if (alpha >= threshold)
      {
        position = { i, crossing->Share };
        return true;
      }
    }
    if (pass(1.0))
    {
      return true;
    }
  }
  return false;
}

bool OpacityDepth::FindExtreme(
  const std::vector<RayPart>& parts, double threshold, RayPosition& position) const
{
  if (parts.empty())
  {
    return false;
  }
  const double sign = this->Mode == BlendMode::Maximum ? 1.0 : -1.0;
  const size_t component = this->Functions.AreIndependent()
    ? 0
    : static_cast<size_t>(this->Functions.GetNumberOfComponents()) - 1;
  const auto getScalars = [&](const RayPosition& at) -> const Scalars&
  { return at.Share == 0.0 ? parts[at.Part].Front : parts[at.Part].Back; };
  position = { 0, 0.0 };
  for (size_t i = 0; i < parts.size(); ++i)
  {
    for (const RayPosition& here : { RayPosition{ i, 0.0 }, RayPosition{ i, 1.0 } })
    {
      if (sign * getScalars(here)[component] > sign * getScalars(position)[component])
      {
        position = here;
      }
    }
  }
  return this->Functions.Map(getScalars(position), parts[position.Part].Steepness).w >= threshold;
}
}
