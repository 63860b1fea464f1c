// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   BenchmarkPixelPoints
 * @brief   where in the world the pixels of a view are
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
  /// As its camera is now.
  explicit BenchmarkPixelPoints(BenchmarkView& view);
  ~BenchmarkPixelPoints();

  /// The centre of a pixel, counted row after row, at a depth of the z-buffer.
  std::array<double, 3> Get(int pixel, double depth) const;

  int GetNumberOfPixels() const { return this->Width * this->Height; }

private:
  const int Width;
  const int Height;
  vtkNew<vtkMatrix4x4> ToWorld;
};

#endif
