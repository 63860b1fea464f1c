// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Surfaces/FloatRange.h"

#include "vtkDisplacement.h"
#include "vtkHeightField.h"
#include "vtkRefinementSurface.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace relevo
{
std::string FindRangeError(vtkRefinementSurface* surface, vtkDisplacement* displacement)
{
  std::ostringstream text;
  if (surface && !(surface->GetReach() <= LargestLength))
  {
    text << surface->GetClassName() << " moves points by up to " << surface->GetReach()
         << ", but floats allow at most " << LargestLength << ": lower its amplitude";
    return text.str();
  }
  if (!displacement)
  {
    return {};
  }
  double range[2] = { 0.0, 0.0 };
  if (displacement->GetHeightMap())
  {
    displacement->GetHeightMap()->GetRange(range);
  }
  // The range of a map without valid heights may be reversed.
  const double highest =
    range[0] > range[1] ? 0.0 : std::max(std::abs(range[0]), std::abs(range[1]));
  const double scale = std::abs(displacement->GetScale());
  // Each term is limited separately, so that they cannot cancel.
  if (!(scale * highest <= LargestLength) || !(scale <= std::numeric_limits<float>::max()) ||
    !(std::abs(displacement->GetOffset()) <= LargestLength))
  {
    text << "the displacement, Scale " << displacement->GetScale() << " x heights of up to "
         << highest << " + Offset " << displacement->GetOffset() << ", exceeds " << LargestLength
         << ", the most that floats allow: lower Scale or Offset, or declare the value of missing "
            "heights (NoDataValue)";
  }
  return text.str();
}
}
