// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Arrays/PointArray.h"

#include "Checks/MisplacedArray.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDataSet.h"
#include "vtkPointData.h"

#include <cmath>
#include <cstddef>
#include <sstream>

namespace relevo
{
vtkDataArray* FindPointArray(
  vtkDataSet* data, const std::string& name, int components, std::string& error)
{
  vtkDataArray* array = data->GetPointData()->GetArray(name.c_str());
  const vtkIdType numberOfPoints = data->GetNumberOfPoints();
  std::ostringstream text;
  text << "point array \"" << name << "\" ";
  if (!array)
  {
    const bool exists = data->GetPointData()->GetAbstractArray(name.c_str()) != nullptr;
    text << (exists ? "holds no numbers" : "does not exist");
    const std::string misplaced =
      DescribeMisplacedArray(data, name, vtkDataObject::FIELD_ASSOCIATION_POINTS);
    error = misplaced.empty() ? text.str() : "there is " + misplaced;
    return nullptr;
  }
  if (array->GetNumberOfComponents() != components || array->GetNumberOfTuples() < numberOfPoints)
  {
    text << "has " << array->GetNumberOfTuples() << " tuples of " << array->GetNumberOfComponents()
         << " components, but " << numberOfPoints << " tuples of " << components << " are needed";
    error = text.str();
    return nullptr;
  }
  for (vtkIdType point = 0; point < numberOfPoints; ++point)
  {
    for (int c = 0; c < components; ++c)
    {
      if (!std::isfinite(static_cast<float>(array->GetComponent(point, c))))
      {
        text << "is not finite at point " << point;
        error = text.str();
        return nullptr;
      }
    }
  }
  return array;
}

bool TakePointArray(vtkDataSet* data, const std::string& name, int components, float* values,
  int stride, std::string& error)
{
  vtkDataArray* array = FindPointArray(data, name, components, error);
  for (vtkIdType point = 0; array && point < data->GetNumberOfPoints(); ++point)
  {
    for (int c = 0; c < components; ++c)
    {
      values[static_cast<std::size_t>(point) * stride + c] =
        static_cast<float>(array->GetComponent(point, c));
    }
  }
  return array != nullptr;
}
}
