// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/ReliefColors.h"

#include "Data/Relief.h"
#include "vtkFloatArray.h"
#include "vtkSMPTools.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace relevo
{
namespace
{
// Returns the value of white, or 0 for types that are not supported.
double GetWhite(int type)
{
  switch (type)
  {
    case VTK_UNSIGNED_CHAR:
      return 255.0;
    case VTK_UNSIGNED_SHORT:
      return 65535.0;
    case VTK_FLOAT:
    case VTK_DOUBLE:
      return 1.0;
    default:
      return 0.0;
  }
}

vtkSmartPointer<vtkUnsignedCharArray> MakeColors(int components, vtkIdType number)
{
  auto colors = vtkSmartPointer<vtkUnsignedCharArray>::New();
  colors->SetName(Relief::GetColorName());
  colors->SetNumberOfComponents(components);
  colors->SetNumberOfTuples(number);
  return colors;
}

unsigned char ToByte(double share)
{
  return static_cast<unsigned char>(
    std::lround(255.0 * (share > 0.0 ? std::min(share, 1.0) : 0.0)));
}
}

vtkSmartPointer<vtkUnsignedCharArray> ConvertColors(vtkDataArray* colors, std::string& error)
{
  const double white = GetWhite(colors->GetDataType());
  const int given = colors->GetNumberOfComponents();
  if (white == 0.0 || given > 4)
  {
    error =
      std::string("Colours must have 1 to 4 components of type unsigned char, unsigned short, "
                  "float or double, not ") +
      std::to_string(given) + " of type " + colors->GetDataTypeAsString() + ".";
    return nullptr;
  }
  const bool isGray = given < 3;
  const int components = given % 2 == 0 ? 4 : 3;
  const vtkIdType number = colors->GetNumberOfTuples();
  auto result = MakeColors(components, number);
  unsigned char* bytes = result->GetPointer(0);
  vtkSMPTools::For(0, number,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        for (int k = 0; k < components; ++k)
        {
          const int from = isGray ? k / 3 : k;
          bytes[i * components + k] = ToByte(colors->GetComponent(i, from) / white);
        }
      }
    });
  return result;
}

ColorSampler::ColorSampler(vtkUnsignedCharArray* colors, const int size[2], const int texels[2])
  : Colors(colors)
  , Size(size[0], size[1])
  , Texels(texels[0], texels[1])
{
  constexpr double most = 16.0;
  this->Steps = ivec2(clamp(ceil(dvec2(this->Size) / this->Texels), 1.0, most));
}

void ColorSampler::Sample(const dvec2& uv, unsigned char* color) const
{
  const dvec2 step = 1.0 / (this->Texels * dvec2(this->Steps));
  const dvec2 first = uv - 0.5 * step * dvec2(this->Steps - 1);
  for (int k = 0; k < this->Colors->GetNumberOfComponents(); ++k)
  {
    double sum = 0.0;
    for (int j = 0; j < this->Steps.y; ++j)
    {
      for (int i = 0; i < this->Steps.x; ++i)
      {
        sum += this->Interpolate(first + step * dvec2(i, j), k);
      }
    }
    color[k] = ToByte(sum / (255.0 * this->Steps.x * this->Steps.y));
  }
}

double ColorSampler::Interpolate(const dvec2& uv, int component) const
{
  const dvec2 last(this->Size - 1);
  const dvec2 place = clamp(uv * dvec2(this->Size) - 0.5, dvec2(0.0), last);
  const ivec2 from(place);
  const ivec2 to = min(from + 1, this->Size - 1);
  const dvec2 share = place - dvec2(from);
  const int components = this->Colors->GetNumberOfComponents();
  const unsigned char* all = this->Colors->GetPointer(0) + component;
  const auto at = [&](int i, int j) -> double
  { return all[(static_cast<vtkIdType>(j) * this->Size.x + i) * components]; };
  return mix(mix(at(from.x, from.y), at(to.x, from.y), share.x),
    mix(at(from.x, to.y), at(to.x, to.y), share.x), share.y);
}

vtkSmartPointer<vtkUnsignedCharArray> MakeDepthColors(vtkFloatArray* depths)
{
  constexpr double darkest = 0.25;
  const vtkIdType number = depths->GetNumberOfTuples();
  const float* all = depths->GetPointer(0);
  double nearest = std::numeric_limits<double>::infinity();
  double farthest = -nearest;
  for (vtkIdType i = 0; i < number; ++i)
  {
    if (std::isfinite(all[i]))
    {
      nearest = std::min<double>(nearest, all[i]);
      farthest = std::max<double>(farthest, all[i]);
    }
  }
  const double range = farthest > nearest ? farthest - nearest : 1.0;
  auto result = MakeColors(3, number);
  for (vtkIdType i = 0; i < number; ++i)
  {
    const double share = 1.0 - (1.0 - darkest) * (all[i] - nearest) / range;
    std::fill_n(result->GetPointer(3 * i), 3, std::isfinite(all[i]) ? ToByte(share) : 0);
  }
  return result;
}
}
