// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Computes an image of a vortex's streaks without a window or OpenGL. Prints the differences of
 * values along and across the streaks.
 */
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkLineIntegralConvolution.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <cmath>
#include <cstdlib>
#include <iostream>

int main()
{
  const int size = 200;
  vtkNew<vtkImageData> vortex;
  vortex->SetDimensions(size, size, 1);
  vortex->AllocateScalars(VTK_FLOAT, 2);
  for (int j = 0; j < size; ++j)
  {
    for (int i = 0; i < size; ++i)
    {
      vortex->SetScalarComponentFromDouble(i, j, 0, 0, 0.5 * (size - 1) - j);
      vortex->SetScalarComponentFromDouble(i, j, 0, 1, i - 0.5 * (size - 1));
    }
  }

  vtkNew<vtkLineIntegralConvolution> convolution;
  convolution->SetInputData(vortex);
  convolution->Update();

  // To the right of the centre, the vectors run along the columns.
  vtkImageData* image = convolution->GetOutput();
  double along = 0.0;
  double across = 0.0;
  for (int j = size / 2 - 10; j < size / 2 + 10; ++j)
  {
    for (int i = size / 2 + 30; i < size - 1; ++i)
    {
      const float here = image->GetScalarComponentAsFloat(i, j, 0, 0);
      along += std::abs(image->GetScalarComponentAsFloat(i, j + 1, 0, 0) - here);
      across += std::abs(image->GetScalarComponentAsFloat(i + 1, j, 0, 0) - here);
    }
  }
  std::cout << "neighbours differ " << across / along << " times as much across as along\n";
  return across > 3.0 * along ? EXIT_SUCCESS : EXIT_FAILURE;
}
