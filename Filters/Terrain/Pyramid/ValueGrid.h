// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @struct  ValueGrid
 * @brief   a rectangle of values, row by row
 *
 * Private to the module.
 */
#ifndef ValueGrid_h
#define ValueGrid_h

#include <algorithm> // for std::min
#include <cstddef>   // for std::size_t
#include <vector>

namespace relevo
{
template <typename T>
struct ValueGrid
{
  int Width = 0;
  int Height = 0;
  std::vector<T> Values;

  ValueGrid() = default;
  ValueGrid(int width, int height, const T& value = T())
    : Width(width)
    , Height(height)
    , Values(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), value)
  {
  }

  const T* GetRow(int row) const
  {
    return this->Values.data() + static_cast<std::size_t>(row) * this->Width;
  }
  T& At(int column, int row)
  {
    return this->Values[static_cast<std::size_t>(row) * this->Width + column];
  }
  const T& At(int column, int row) const
  {
    return this->Values[static_cast<std::size_t>(row) * this->Width + column];
  }
  /// The nearest value, for positions beyond the last.
  const T& GetNearest(int column, int row) const
  {
    return this->At(std::min(column, this->Width - 1), std::min(row, this->Height - 1));
  }
};
}

#endif
