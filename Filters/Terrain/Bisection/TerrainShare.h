// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @struct  TerrainShare
 * @brief   a rectangle of samples whose faces one of several processes draws
 *
 * The shares of all processes cover the plane without overlaps. Outer sides are at infinity.
 *
 * Private to the modules for terrains.
 */
#ifndef TerrainShare_h
#define TerrainShare_h

#include <array>
#include <limits>

namespace relevo
{
struct TerrainShare
{
  using Range = std::array<double, 2>; // from the first on, and before the last

  Range Columns = { { -std::numeric_limits<double>::infinity(),
    std::numeric_limits<double>::infinity() } };
  Range Rows = { { -std::numeric_limits<double>::infinity(),
    std::numeric_limits<double>::infinity() } };

  bool Contains(double column, double row) const
  {
    return column >= this->Columns[0] && column < this->Columns[1] && row >= this->Rows[0] &&
      row < this->Rows[1];
  }

  bool Overlaps(const Range& columns, const Range& rows) const
  {
    return columns[0] <= this->Columns[1] && columns[1] >= this->Columns[0] &&
      rows[0] <= this->Rows[1] && rows[1] >= this->Rows[0];
  }

  bool operator==(const TerrainShare& other) const
  {
    return this->Columns == other.Columns && this->Rows == other.Rows;
  }
};
}

#endif
