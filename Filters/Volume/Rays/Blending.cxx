// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Rays/Blending.h"

#include "Rays/ScalarBlending.h"

namespace relevo
{
dvec4 Blending::Blend(const std::vector<RayPart>& parts, const dvec3& direction) const
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
      return this->BlendIsoSurfaces(parts, direction);
    default:
      return this->BlendComposite(parts, direction);
  }
}

Segment Blending::Light(const RayPart& part, const dvec3& direction) const
{
  Segment segment = { part.Front, part.Back, part.End - part.Begin, part.Steepness };
  if (this->IsShaded)
  {
    segment.IsLit = true;
    segment.FrontLights = this->Shades.GetLights(part.FrontGradients, -direction);
    segment.BackLights = this->Shades.GetLights(part.BackGradients, -direction);
  }
  return segment;
}

dvec4 Blending::ShowSurface(
  const RayPart& part, const IsoCrossing& crossing, const dvec3& direction) const
{
  const dvec4 value = this->Surfaces.GetColor(this->Functions, part, crossing);
  dvec3 color(value);
  if (this->IsShaded)
  {
    const Gradients gradients =
      Interpolate(part.FrontGradients, part.BackGradients, crossing.Share);
    const Lights lights = this->Shades.GetLights(gradients, -direction);
    color = lightenColor(color, lights[this->Surfaces.GetCurve()]);
  }
  return dvec4(value.w * color, value.w);
}

dvec4 Blending::BlendComposite(const std::vector<RayPart>& parts, const dvec3& direction) const
{
  const std::vector<IsoCrossing> crossings = this->Surfaces.Cross(parts);
  auto crossing = crossings.begin();
  dvec4 seen(0.0);
  for (size_t i = 0; i < parts.size(); ++i)
  {
    const Segment segment = this->Light(parts[i], direction);
    double begin = 0.0;
    for (; crossing != crossings.end() && crossing->Part == i; ++crossing)
    {
      seen = frontOverBack(seen, this->Functions.Integrate(segment.Cut(begin, crossing->Share)));
      seen = frontOverBack(seen, this->ShowSurface(parts[i], *crossing, direction));
      begin = crossing->Share;
    }
    seen = frontOverBack(
      seen, this->Functions.Integrate(begin > 0.0 ? segment.Cut(begin, 1.0) : segment));
  }
  return seen;
}

dvec4 Blending::BlendIsoSurfaces(const std::vector<RayPart>& parts, const dvec3& direction) const
{
  dvec4 seen(0.0);
  for (const IsoCrossing& crossing : this->Surfaces.Cross(parts))
  {
    seen = frontOverBack(seen, this->ShowSurface(parts[crossing.Part], crossing, direction));
  }
  return seen;
}

dvec4 Blending::BlendAdditive(const std::vector<RayPart>& parts) const
{
  dvec4 sum(0.0);
  for (const RayPart& part : parts)
  {
    sum += this->Functions.Sum({ part.Front, part.Back, part.End - part.Begin, part.Steepness });
  }
  return min(sum, dvec4(1.0));
}
}
