// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @struct  LICField
 * @brief   the convolution that shaders and C++ share, for a pixel of an image
 *
 * Private to the module.
 */
#ifndef LICField_h
#define LICField_h

#include "Image/LICKernel.h"

#include "vtkType.h"

namespace relevo
{
struct LICField
{
  vec2 licField(vec2 p) const
  {
    const bool inside = p.x >= 0.0f && p.y >= 0.0f && p.x < static_cast<float>(this->Columns) &&
      p.y < static_cast<float>(this->Rows); // false for NaN
    if (!inside)
    {
      return vec2(0.0f);
    }
    const vtkIdType stride = this->Columns + vtkIdType(2);
    const vec2 padded = p + 0.5f;
    const ivec2 cell = ivec2(padded);
    const vec2 part = padded - vec2(cell);
    const vec2* corner = this->Vectors + cell.y * stride + cell.x;
    const vec2& nearest = corner[(part.x < 0.5f ? 0 : vtkIdType(1)) + (part.y < 0.5f ? 0 : stride)];
    return nearest == vec2(0.0f) ? nearest
                                 : mix(mix(corner[0], corner[1], part.x),
                                     mix(corner[stride], corner[stride + 1], part.x), part.y);
  }

  float licNoise(vec2 p) const
  {
    return this->Noise[static_cast<vtkIdType>(p.y) * this->Columns + static_cast<vtkIdType>(p.x)];
  }

#include "glsl/relevoLIC.glsl"

  int Columns;
  int Rows;
  const vec2* Vectors; // padded, from LICVectors
  const float* Noise;  // one per sample
};
}

#endif
