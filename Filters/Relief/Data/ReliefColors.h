// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   the colours of reliefs: of other types, or of depths alone
 *
 * Private to the modules' own sources.
 */
#ifndef ReliefColors_h
#define ReliefColors_h

#include "Mathematics/RefinementMathematics.h"
#include "vtkSmartPointer.h"

#include <string>

class vtkDataArray;
class vtkFloatArray;
class vtkUnsignedCharArray;

namespace relevo
{
/**
 * Colours of 1 to 4 components (grey, grey and opacity, RGB, RGBA) as 3 or 4 bytes each: unsigned
 * char as they are, unsigned short from 0 to 65535, float and double from 0 to 1. nullptr, and what
 * is wrong with them in `fault`, for others.
 */
vtkSmartPointer<vtkUnsignedCharArray> ConvertColors(vtkDataArray* colors, std::string& error);

/// Colours on the unit square, sampled by texels of some size.
class ColorSampler
{
public:
  /// The colours of a picture of this size, row 0 at v = 0; and how many texels look at it.
  ColorSampler(vtkUnsignedCharArray* colors, const int size[2], const int texels[2]);

  /// The mean of a texel around (u, v), bilinear between the centres of pixels.
  void Sample(const dvec2& uv, unsigned char* color) const;

private:
  double Interpolate(const dvec2& uv, int component) const;

  vtkSmartPointer<vtkUnsignedCharArray> Colors;
  const ivec2 Size;
  const dvec2 Texels;
  ivec2 Steps; // places in a texel, along u and v
};

/// Grey: white is nearest, dark grey farthest, black where nothing was seen.
vtkSmartPointer<vtkUnsignedCharArray> MakeDepthColors(vtkFloatArray* depths);
}

#endif
