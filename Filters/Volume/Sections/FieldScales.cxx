// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Sections/FieldScales.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>

namespace relevo
{
FieldScales::FieldScales(vtkDataSet* data)
{
  vtkPointData* points = data->GetPointData();
  for (int i = 0; i < points->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = points->GetArray(i);
    const bool isOfReals =
      array && (array->GetDataType() == VTK_FLOAT || array->GetDataType() == VTK_DOUBLE);
    if (!isOfReals || array->GetNumberOfTuples() < data->GetNumberOfPoints() ||
      array == points->GetRationalWeights())
    {
      continue;
    }
    // Components are compared with the largest one.
    double largest = 0.0;
    for (int c = 0; c < array->GetNumberOfComponents(); ++c)
    {
      double range[2];
      array->GetFiniteRange(range, c);
      largest = std::max(largest, range[1] - range[0]);
    }
    for (int c = 0; largest > 0.0 && c < array->GetNumberOfComponents(); ++c)
    {
      this->Fields.push_back({ array, c, 1.0 / largest });
    }
  }
}

int FieldScales::GetNumberOfGroups() const
{
  return (static_cast<int>(this->Fields.size()) + MaximumComponents - 1) / MaximumComponents;
}

int FieldScales::GetSize(int group) const
{
  const int first = group * MaximumComponents;
  return std::min(static_cast<int>(this->Fields.size()) - first, MaximumComponents);
}

Scalars FieldScales::Get(int group, vtkIdType point) const
{
  Scalars values{};
  for (int i = 0; i < this->GetSize(group); ++i)
  {
    const Field& field = this->Fields[group * MaximumComponents + i];
    const double value = field.Factor * field.Array->GetComponent(point, field.Component);
    values[i] = std::isfinite(value) ? value : 0.0;
  }
  return values;
}
}
