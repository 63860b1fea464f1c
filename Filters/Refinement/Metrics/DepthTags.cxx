// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Metrics/DepthTags.h"

#include "vtkDataArray.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace
{
constexpr double LargestTag = 1e38;
}

namespace relevo
{
bool TakeDepthTags(vtkDataArray* array, vtkIdType numberOfPoints, float* tags, std::string& error)
{
  std::ostringstream text;
  text << "point array \"" << (array->GetName() ? array->GetName() : "") << "\" of depth-tags ";
  if (array->GetNumberOfComponents() != 1 || array->GetNumberOfTuples() != numberOfPoints)
  {
    text << "has " << array->GetNumberOfTuples() << " tuples of " << array->GetNumberOfComponents()
         << " components for " << numberOfPoints << " points; it needs one value per point";
    error = text.str();
    return false;
  }
  for (vtkIdType point = 0; point < numberOfPoints; ++point)
  {
    const double tag = array->GetComponent(point, 0);
    if (std::isnan(tag))
    {
      text << "is NaN at point " << point;
      error = text.str();
      return false;
    }
    tags[point] = static_cast<float>(std::min(std::max(tag, -LargestTag), LargestTag));
  }
  return true;
}
}
