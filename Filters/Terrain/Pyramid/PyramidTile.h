// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   PyramidTile
 * @brief   the samples of one tile of a raster pyramid, in memory
 *
 * Samples are as stored, without scale and offset, and NaN where data are missing. They are floats
 * where floats are exact.
 *
 * Private to the module.
 */
#ifndef PyramidTile_h
#define PyramidTile_h

#include "Pyramid/SampleWindow.h"

#include <cstddef>
#include <vector>

namespace relevo
{
struct PyramidTile
{
  SampleWindow Window;
  std::vector<float> Floats; // or
  std::vector<double> Doubles;

  /// The sample in a column and row of the level.
  double GetSample(int column, int row) const
  {
    const std::size_t i = static_cast<std::size_t>(row - this->Window.Row) * this->Window.Width +
      static_cast<std::size_t>(column - this->Window.Column);
    return this->Doubles.empty() ? this->Floats[i] : this->Doubles[i];
  }

  std::size_t GetMemorySize() const
  {
    return sizeof(*this) + this->Floats.capacity() * sizeof(float) +
      this->Doubles.capacity() * sizeof(double);
  }
};
}

#endif
