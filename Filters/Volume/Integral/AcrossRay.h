// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   AcrossRay
 * @brief   coordinates along two directions perpendicular to a ray
 *
 * Private to the module.
 */
#ifndef AcrossRay_h
#define AcrossRay_h

#include "Mathematics/RefinementMathematics.h"

namespace relevo
{
class AcrossRay
{
public:
  explicit AcrossRay(const dvec3& direction)
  {
    const dvec3 size = abs(direction);
    const dvec3 axis = size.x <= size.y && size.x <= size.z ? dvec3(1.0, 0.0, 0.0)
      : size.y <= size.z                                    ? dvec3(0.0, 1.0, 0.0)
                                                            : dvec3(0.0, 0.0, 1.0);
    this->First = normalize(cross(direction, axis));
    this->Second = cross(direction, this->First);
  }
  dvec2 operator()(const dvec3& v) const
  {
    return dvec2(dot(v, this->First), dot(v, this->Second));
  }

private:
  dvec3 First;
  dvec3 Second;
};
}

#endif
