// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   SurfaceConvolution
 * @brief   the line integral convolution of solid noise at one place of a surface
 *
 * Private to the module's own sources.
 */
#ifndef SurfaceConvolution_h
#define SurfaceConvolution_h

#include "Image/LICKernel.h"
#include "Noise/SolidNoise.h"
#include "Surface/SurfaceStreamline.h"

#include <array>
#include <vector>

namespace relevo
{
class SurfaceConvolution
{
public:
  /// The kernel's steps are those of SurfaceStreamline.
  SurfaceConvolution(
    const SurfaceVectors& vectors, const SolidNoise& noise, const LICKernel& kernel);

  /// At a place of the surface's points.
  float GetValueAt(vtkIdType mergedPoint) const;

  /// In a triangle.
  float GetValueInside(int triangle, const SurfaceVectors::Weights& weights) const;

private:
  template <typename Begin>
  float Convolve(const double start[3], const Begin& begin) const;

  const SurfaceVectors& Vectors;
  const SolidNoise& Noise;
  LICKernel Kernel;
  /// Upstream and downstream, from the start on.
  std::array<std::vector<double>, 2> Weights;
};
}

#endif
