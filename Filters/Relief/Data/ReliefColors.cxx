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
// What stands for white, or 0 for types that are no colours.
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
  return static_cast<unsigned char>(255.0 * (share > 0.0 ? std::min(share, 1.0) : 0.0) + 0.5);
}
}

vtkSmartPointer<vtkUnsignedCharArray> ConvertColors(vtkDataArray* colors, std::string& fault)
{
  const double white = GetWhite(colors->GetDataType());
  const int given = colors->GetNumberOfComponents();
  if (white == 0.0 || given > 4)
  {
    fault = std::string("Colours have 1 to 4 components of type unsigned char, unsigned short, "
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
