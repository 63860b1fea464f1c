// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   BenchmarkPixelPoints
 * @brief   world coordinates of a view's pixels
 */
#ifndef BenchmarkPixelPoints_h
#define BenchmarkPixelPoints_h

#include "vtkNew.h"

#include <array>

class BenchmarkView;
class vtkMatrix4x4;

class BenchmarkPixelPoints
{
public:
  /// Uses the camera's current state.
  explicit BenchmarkPixelPoints(BenchmarkView& view);
  ~BenchmarkPixelPoints();

  /// World coordinates of a pixel's centre at a depth of the z-buffer. Pixels are counted row by
  /// row.
  std::array<double, 3> Get(int pixel, double depth) const;

  int GetNumberOfPixels() const { return this->Width * this->Height; }

private:
  const int Width;
  const int Height;
  vtkNew<vtkMatrix4x4> ToWorld;
};

#endif
