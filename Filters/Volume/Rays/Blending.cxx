// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Rays/Blending.h"

#include "Rays/ScalarBlending.h"

namespace relevo
{
dvec4 Blending::Blend(const std::vector<RayPart>& parts) const
{
  switch (this->Mode)
  {
    case BlendMode::Maximum:
      return BlendExtreme(this->Functions, parts, 1.0);
    case BlendMode::Minimum:
      return BlendExtreme(this->Functions, parts, -1.0);
    case BlendMode::Average:
      return BlendAverage(this->Functions, parts);
    case BlendMode::Additive:
      return this->BlendAdditive(parts);
    case BlendMode::IsoSurface:
      return this->BlendIsoSurfaces(parts);
    default:
      return this->BlendComposite(parts);
  }
}

dvec4 Blending::BlendComposite(const std::vector<RayPart>& parts) const
{
  const std::vector<IsoCrossing> crossings = this->Surfaces.Cross(parts);
  auto crossing = crossings.begin();
  dvec4 seen(0.0);
  for (size_t i = 0; i < parts.size(); ++i)
  {
    double begin = 0.0;
    const auto addUpTo = [&](double end)
    {
      const RayPart part = parts[i].Cut(begin, end);
      seen = frontOverBack(
        seen, this->Functions.Integrate(part.Front, part.Back, part.End - part.Begin));
      begin = end;
    };
    for (; crossing != crossings.end() && crossing->Part == i; ++crossing)
    {
      addUpTo(crossing->Share);
      seen = frontOverBack(seen, this->Surfaces.GetColor(this->Functions, parts[i], *crossing));
    }
    addUpTo(1.0);
  }
  return seen;
}

dvec4 Blending::BlendIsoSurfaces(const std::vector<RayPart>& parts) const
{
  dvec4 seen(0.0);
  for (const IsoCrossing& crossing : this->Surfaces.Cross(parts))
  {
    const RayPart& part = parts[crossing.Part];
    seen = frontOverBack(seen, this->Surfaces.GetColor(this->Functions, part, crossing));
  }
  return seen;
}

dvec4 Blending::BlendAdditive(const std::vector<RayPart>& parts) const
{
  dvec4 sum(0.0);
  for (const RayPart& part : parts)
  {
    sum += this->Functions.Sum(part.Front, part.Back, part.End - part.Begin);
  }
  return min(sum, dvec4(1.0));
}
}
