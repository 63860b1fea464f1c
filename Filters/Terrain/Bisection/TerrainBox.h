// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @struct  TerrainBox
 * @brief   a box of a raster: columns, rows and heights
 *
 * Private to the modules for terrains.
 */
#ifndef TerrainBox_h
#define TerrainBox_h

#include <array>

namespace relevo
{
struct TerrainBox
{
  std::array<double, 2> Columns;
  std::array<double, 2> Rows;
  std::array<double, 2> Heights;
};
}

#endif
