// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   conversion of arrays and depths to colours of reliefs
 *
 * Private to the modules.
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
 * Converts colours of 1 to 4 components (grey, grey and opacity, RGB, RGBA) to 3 or 4 bytes.
 * unsigned char is used unchanged, unsigned short ranges from 0 to 65535, float and double from 0
 * to 1. Returns nullptr with an `error` for other colours.
 */
vtkSmartPointer<vtkUnsignedCharArray> ConvertColors(vtkDataArray* colors, std::string& error);

/// Samples colours on the unit square for texels of a given size.
class ColorSampler
{
public:
  /// `size` is the size of the image with the colours, with row 0 at v = 0. `texels` is the number
  /// of texels that sample it in each direction.
  ColorSampler(vtkUnsignedCharArray* colors, const int size[2], const int texels[2]);

  /// Computes the mean over a texel around (u, v), with bilinear interpolation between pixel
  /// centres.
  void Sample(const dvec2& uv, unsigned char* color) const;

private:
  double Interpolate(const dvec2& uv, int component) const;

  vtkSmartPointer<vtkUnsignedCharArray> Colors;
  const ivec2 Size;
  const dvec2 Texels;
  ivec2 Steps; // samples per texel, along u and v
};

/// Returns grey values: white is nearest, dark grey farthest, black is no surface.
vtkSmartPointer<vtkUnsignedCharArray> MakeDepthColors(vtkFloatArray* depths);
}

#endif
