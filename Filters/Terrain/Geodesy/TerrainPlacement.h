// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @struct  TerrainPlacement
 * @brief   the position of a raster in world coordinates
 *
 * A point of the raster at column x, row y (whole numbers at the centres of samples) and height h
 * lies at Origin + x * Column + y * Row + (0, 0, h * HeightScale) in world coordinates.
 *
 * Private to the modules for terrains.
 */
#ifndef TerrainPlacement_h
#define TerrainPlacement_h

#include <array>

namespace relevo
{
struct TerrainPlacement
{
  std::array<double, 2> Origin = { { 0.0, 0.0 } };
  std::array<double, 2> Column = { { 1.0, 0.0 } };
  std::array<double, 2> Row = { { 0.0, -1.0 } };
  double HeightScale = 1.0;

  std::array<double, 3> ToWorld(double x, double y, double height) const
  {
    return { { this->Origin[0] + x * this->Column[0] + y * this->Row[0],
      this->Origin[1] + x * this->Column[1] + y * this->Row[1], height * this->HeightScale } };
  }
};
}

#endif
