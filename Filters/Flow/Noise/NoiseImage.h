// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   square images from a function of column and row
 *
 * Pixel (column, row) is element column + size * row. Private to the module.
 */
#ifndef NoiseImage_h
#define NoiseImage_h

#include "vtkSMPTools.h"
#include "vtkType.h"

#include <vector>

namespace relevo
{
/// Evaluates f(column, row) for all pixels, in parallel.
template <typename Function>
std::vector<float> MakeNoiseImage(int size, Function&& f)
{
  std::vector<float> image(static_cast<std::size_t>(size) * size);
  vtkSMPTools::For(0, size,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (int row = static_cast<int>(begin); row < end; ++row)
      {
        float* value = image.data() + static_cast<std::size_t>(row) * size;
        for (int column = 0; column < size; ++column)
        {
          value[column] = f(column, row);
        }
      }
    });
  return image;
}
}

#endif
