// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeightSampler
 * @brief   the shared height functions over an up-to-date vtkHeightField
 *
 * Private to the module's own sources.
 */
#ifndef vtkHeightSampler_h
#define vtkHeightSampler_h

#include "vtkHeightField.h"
#include "vtkRefinementMathematics.h"

namespace relevo
{
struct HeightSampler
{
  explicit HeightSampler(vtkHeightField* field)
    : Samples(field->GetSamples())
    , Validity(field->GetValidity())
  {
    int dimensions[2];
    field->GetDimensions(dimensions);
    this->Size = ivec2(dimensions[0], dimensions[1]);
  }

  size_t index(ivec2 texel) const { return static_cast<size_t>(texel.y) * this->Size.x + texel.x; }
  float heightTexel(ivec2 texel) const { return this->Samples[this->index(texel)]; }
  float validTexel(ivec2 texel) const
  {
    return this->Validity && !this->Validity[this->index(texel)] ? 0.0f : 1.0f;
  }
  ivec2 heightSize() const { return this->Size; }

#include "glsl/relevoHeight.glsl"

  const float* Samples;
  const unsigned char* Validity;
  ivec2 Size;
};
}

#endif
