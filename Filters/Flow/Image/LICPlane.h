// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @struct  LICPlane
 * @brief   the two axes of a flat image
 *
 * Sample (i, j) is point i + Columns * j of the image for all axes.
 *
 * Private to the module.
 */
#ifndef LICPlane_h
#define LICPlane_h

#include "vtkType.h"

#include <string>

class vtkImageData;

namespace relevo
{
struct LICPlane
{
  /// Selects the first of XY, XZ and YZ in which the image is flat. Returns false with an `error`
  /// if the image is empty, not flat, or too large for float positions.
  bool Find(vtkImageData* image, std::string& error);

  vtkIdType GetNumberOfSamples() const
  {
    return static_cast<vtkIdType>(this->Columns) * this->Rows;
  }

  int Axes[2] = { 0, 1 };
  int Columns = 0;
  int Rows = 0;
};
}

#endif
