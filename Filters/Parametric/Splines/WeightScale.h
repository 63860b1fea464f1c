// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   WeightScale
 * @brief   scales double weights to the range of float
 *
 * A common factor of all weights cancels out. With a power of two, results are bitwise identical.
 *
 * Private to the modules.
 */
#ifndef WeightScale_h
#define WeightScale_h

#include "Mathematics/RefinementMathematics.h"
#include "vtkType.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace relevo
{
class WeightScale
{
public:
  /// getPoint(i) returns control point i, from first to end - 1, with the weight last.
  template <typename GetPoint>
  WeightScale(vtkIdType first, vtkIdType end, const GetPoint& getPoint)
  {
    double largest = 0.0;
    for (vtkIdType i = first; i < end; ++i)
    {
      largest = std::max(largest, getPoint(i).w);
    }
    this->Exponent = largest > 0.0 ? std::ilogb(largest) : 0;
  }

  /// Returns a weight greater than 0 and at most 2.
  float GetWeight(const dvec4& point) const
  {
    const auto weight = static_cast<float>(std::ldexp(point.w, -this->Exponent));
    return std::max(weight, std::numeric_limits<float>::min());
  }

private:
  int Exponent;
};
}

#endif
