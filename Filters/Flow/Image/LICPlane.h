// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @struct  LICPlane
 * @brief   the two axes that a flat image extends along
 *
 * Sample (i, j) is the image's point i + Columns * j, whichever the axes are.
 *
 * Private to the module's own sources.
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
  /// Takes the first of XY, XZ and YZ that the image is flat in. False, and why, if it is empty,
  /// flat in none of them or too large for places in floats.
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
