// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @struct  HeightSampler
 * @brief   the shared height functions for an up-to-date vtkHeightField, or for none
 */
#ifndef HeightSampler_h
#define HeightSampler_h

#include "Mathematics/RefinementMathematics.h"

namespace relevo
{
struct HeightSampler
{
  /// A field with one sample, 0.
  HeightSampler() = default;

  /// Sample a vtkHeightField, which uses this struct itself. nullptr is a field with one sample, 0.
  template <typename Field>
  explicit HeightSampler(Field* field)
  {
    if (field)
    {
      int dimensions[2];
      field->GetDimensions(dimensions);
      this->Size = ivec2(dimensions[0], dimensions[1]);
      this->Samples = field->GetSamples();
      this->Validity = field->GetValidity();
    }
  }

  size_t index(ivec2 texel) const { return static_cast<size_t>(texel.y) * this->Size.x + texel.x; }
  float heightTexel(ivec2 texel) const
  {
    return this->Samples ? this->Samples[this->index(texel)] : 0.0f;
  }
  float validTexel(ivec2 texel) const
  {
    return this->Validity && !this->Validity[this->index(texel)] ? 0.0f : 1.0f;
  }
  ivec2 heightSize() const { return this->Size; }

#include "glsl/relevoHeight.glsl"

  const float* Samples = nullptr;
  const unsigned char* Validity = nullptr;
  ivec2 Size = ivec2(1);
};
}

#endif
