// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Buffers/DirectColors.h"

#include "vtkDataArray.h"

namespace relevo
{
namespace
{
void StoreColor(const double* tuple, int components, double scale, float* color)
{
  const bool isGrey = components < 3;
  for (int c = 0; c < 3; ++c)
  {
    color[c] = static_cast<float>(tuple[isGrey ? 0 : c] * scale);
  }
  const bool hasAlpha = components == 2 || components == 4;
  color[3] = hasAlpha ? static_cast<float>(tuple[components - 1] * scale) : 1.0f;
}
}

std::vector<float> GetDirectColors(vtkDataArray* values, int type)
{
  const int components = values->GetNumberOfComponents();
  const bool isReal = type == VTK_FLOAT || type == VTK_DOUBLE;
  if ((!isReal && type != VTK_UNSIGNED_CHAR) || components < 1 || components > 4)
  {
    return {};
  }
  std::vector<float> colors(4 * static_cast<size_t>(values->GetNumberOfTuples()));
  double tuple[4];
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    values->GetTuple(i, tuple);
    StoreColor(tuple, components, isReal ? 1.0 : 1.0 / 255.0, &colors[4 * static_cast<size_t>(i)]);
  }
  return colors;
}
}
