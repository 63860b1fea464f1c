// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/PointArray.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <cmath>
#include <cstddef>
#include <sstream>

namespace relevo
{
bool TakePointArray(vtkPolyData* mesh, const std::string& name, int components, float* values,
  int stride, std::string& error)
{
  vtkDataArray* array = mesh->GetPointData()->GetArray(name.c_str());
  const vtkIdType numberOfPoints = mesh->GetNumberOfPoints();
  std::ostringstream text;
  text << "point array \"" << name << "\" ";
  if (!array)
  {
    text << "is missing, or has no numbers";
    error = text.str();
    return false;
  }
  if (array->GetNumberOfComponents() != components || array->GetNumberOfTuples() < numberOfPoints)
  {
    text << "has " << array->GetNumberOfTuples() << " tuples of " << array->GetNumberOfComponents()
         << " components; " << components << " for each of " << numberOfPoints
         << " points are needed";
    error = text.str();
    return false;
  }
  for (vtkIdType point = 0; point < numberOfPoints; ++point)
  {
    for (int c = 0; c < components; ++c)
    {
      const float value = static_cast<float>(array->GetComponent(point, c));
      if (!std::isfinite(value))
      {
        text << "is not finite at point " << point;
        error = text.str();
        return false;
      }
      values[static_cast<std::size_t>(point) * stride + c] = value;
    }
  }
  return true;
}
}
