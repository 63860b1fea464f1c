// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @struct  LICFilters
 * @brief   the LIC image filters that shaders and C++ share, for an image in memory
 *
 * Private to the module.
 */
#ifndef LICFilters_h
#define LICFilters_h

#include "Image/LICPlane.h"
#include "Mathematics/RefinementMathematics.h"

namespace relevo
{
struct LICFilters
{
  vtkIdType index(ivec2 pixel) const
  {
    return static_cast<vtkIdType>(pixel.y) * this->Plane.Columns + pixel.x;
  }
  bool isInside(ivec2 pixel) const
  {
    return pixel.x >= 0 && pixel.y >= 0 && pixel.x < this->Plane.Columns &&
      pixel.y < this->Plane.Rows;
  }
  float licValue(ivec2 pixel) const
  {
    return this->isInside(pixel) ? this->Values[this->index(pixel)] : 0.0f;
  }
  bool licIsMasked(ivec2 pixel) const
  {
    return !this->isInside(pixel) || this->Mask[this->index(pixel)];
  }

#include "glsl/relevoLICFilters.glsl"

  const LICPlane& Plane;
  const unsigned char* Mask; // one per sample, 0 or 1
  const float* Values;       // one per sample
};
}

#endif
