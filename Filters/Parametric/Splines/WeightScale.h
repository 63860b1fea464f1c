// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   WeightScale
 * @brief   weights as floats, which have less room than the doubles that they come in
 *
 * A factor that all weights have in common cancels out; one that is a power of two leaves results
 * as they are, to the bit.
 *
 * Private to the modules' own sources.
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
  /// getPoint(i) is control point i, first to end - 1, its weight last.
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

  /// More than 0, and 2 at most.
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
