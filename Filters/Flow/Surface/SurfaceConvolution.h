// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   SurfaceConvolution
 * @brief   line integral convolution of solid noise at a position on a surface
 *
 * Private to the module.
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
  /// The steps of the kernel are those of SurfaceStreamline.
  SurfaceConvolution(
    const SurfaceVectors& vectors, const SolidNoise& noise, const LICKernel& kernel);

  /// Returns the LIC at a merged point.
  float GetValueAt(vtkIdType mergedPoint) const;

  /// Returns the LIC in a triangle.
  float GetValueInside(int triangle, const SurfaceVectors::Weights& weights) const;

private:
  template <typename Begin>
  float Convolve(const double start[3], const Begin& begin) const;

  const SurfaceVectors& Vectors;
  const SolidNoise& Noise;
  LICKernel Kernel;
  /// Weights upstream and downstream, from the start.
  std::array<std::vector<double>, 2> Weights;
};
}

#endif
