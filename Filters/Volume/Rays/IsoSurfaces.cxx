// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Rays/IsoSurfaces.h"

#include "vtkContourValues.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace relevo
{
namespace
{
// Relative to the distance along the ray. Cells with a smaller gap are adjacent.
constexpr double Touching = 1e-9;
// Relative to the largest scalar of the ray: the rounding error in cells of constant value.
constexpr double Rounding = 1e-12;

size_t FindHeaviest(vtkVolumeProperty* property, size_t components)
{
  int heaviest = 0;
  for (int i = 1; i < static_cast<int>(components); ++i)
  {
    if (property->GetComponentWeight(i) > property->GetComponentWeight(heaviest))
    {
      heaviest = i;
    }
  }
  return static_cast<size_t>(heaviest);
}
}

IsoSurfaces::IsoSurfaces(vtkVolumeProperty* property, const TransferFunctions& functions)
{
  vtkContourValues* values = property->GetIsoSurfaceValues();
  for (int i = 0; i < values->GetNumberOfContours(); ++i)
  {
    if (std::isfinite(values->GetValue(i)))
    {
      this->Values.push_back(values->GetValue(i));
    }
  }
  std::sort(this->Values.begin(), this->Values.end());
  this->Values.erase(std::unique(this->Values.begin(), this->Values.end()), this->Values.end());
  if (functions.AreIndependent())
  {
    this->Curve = FindHeaviest(property, functions.GetCurves().size());
    this->Component = functions.GetCurves()[this->Curve].Component;
  }
  else
  {
    this->Component = functions.AreColors() ? MaximumComponents - 1 : 0;
  }
}

std::string IsoSurfaces::DescribeMissing(vtkVolumeProperty* property, const SurfaceData& data)
{
  vtkContourValues* values = property->GetIsoSurfaceValues();
  std::ostringstream missing;
  int count = 0;
  bool hasLowest = false;
  bool hasHighest = false;
  for (int i = 0; i < values->GetNumberOfContours(); ++i)
  {
    const double value = values->GetValue(i);
    if (!(value >= data.Low && value <= data.High)) // NaN is missing too
    {
      missing << (count++ > 0 ? ", " : "") << value;
    }
    hasLowest = hasLowest || value == data.Low;
    hasHighest = hasHighest || (value == data.High && data.High > data.Low);
  }
  std::ostringstream text;
  const char* space = "";
  if (count > 0)
  {
    text << "There " << (count > 1 ? "are no isosurfaces" : "is no isosurface") << " at "
         << missing.str() << ": the array's values range from " << data.Low << " to " << data.High
         << ".";
    space = " ";
  }
  if (hasLowest)
  {
    text << space << "There is no isosurface at " << data.Low
         << ", the array's lowest value: no value is below it.";
    space = " ";
  }
  if (hasHighest)
  {
    text << space << "The isosurface at " << data.High
         << ", the array's highest value, consists only of faces whose points all have this value.";
  }
  return text.str();
}

std::vector<IsoCrossing> IsoSurfaces::Cross(const std::vector<RayPart>& parts) const
{
  std::vector<IsoCrossing> crossings;
  if (this->Values.empty())
  {
    return crossings;
  }
  double size = 0.0;
  for (const RayPart& part : parts)
  {
    size = std::max(
      { size, std::abs(part.Front[this->Component]), std::abs(part.Back[this->Component]) });
  }
  double last = 0.0;
  for (size_t i = 0; i < parts.size(); ++i)
  {
    const double front = parts[i].Front[this->Component];
    const double back = parts[i].Back[this->Component];
    const bool touches = i > 0 && parts[i].Begin - parts[i - 1].End <= Touching * parts[i].Begin &&
      std::abs(front - last) <= Same * size;
    this->Cross({ i, 0.0, touches ? last : front }, { i, 1.0, back }, Rounding * size, crossings);
    last = back;
  }
  return crossings;
}

void IsoSurfaces::Cross(const IsoCrossing& front, const IsoCrossing& back, double rounding,
  std::vector<IsoCrossing>& crossings) const
{
  const size_t first = crossings.size();
  for (const double value : this->Values)
  {
    const double least = value - rounding;
    if ((front.Value < least) != (back.Value < least))
    {
      const double share = (value - front.Value) / (back.Value - front.Value);
      crossings.push_back({ front.Part, std::clamp(share, 0.0, 1.0), value });
    }
  }
  if (back.Value < front.Value)
  {
    std::reverse(crossings.begin() + first, crossings.end());
  }
}

dvec4 IsoSurfaces::GetColor(
  const TransferFunctions& functions, const RayPart& part, const IsoCrossing& crossing) const
{
  Scalars scalars = Interpolate(part.Front, part.Back, crossing.Share);
  scalars[this->Component] = crossing.Value;
  if (functions.AreDependent())
  {
    scalars.fill(crossing.Value);
  }
  return functions.AreIndependent() ? functions.MapCurve(this->Curve, scalars, part.Steepness)
                                    : functions.Map(scalars, part.Steepness);
}
}
