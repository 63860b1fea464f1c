// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @struct  TerrainPlacement
 * @brief   the position of a raster in world coordinates
 *
 * A point of the raster at column x, row y (whole numbers at the centres of samples) and height h
 * lies at Origin + x * Column + y * Row + (0, 0, h * HeightScale) in world coordinates. With a
 * Globe, it lies h * HeightScale above the ellipsoid.
 *
 * Private to the modules for terrains.
 */
#ifndef TerrainPlacement_h
#define TerrainPlacement_h

#include "Geodesy/GlobeShape.h"

#include <array>
#include <memory>

namespace relevo
{
struct TerrainPlacement
{
  std::array<double, 2> Origin = { { 0.0, 0.0 } };
  std::array<double, 2> Column = { { 1.0, 0.0 } };
  std::array<double, 2> Row = { { 0.0, -1.0 } };
  double HeightScale = 1.0;
  std::shared_ptr<const GlobeShape> Globe; // nullptr on a map
  double Exaggeration = 1.0;               // is part of HeightScale
  double LowestHeight = 0.0; // times HeightScale; the horizon is that of the ellipsoid
                             // through it
  /// Added to the errors of the first and the last row, whose triangles close the poles.
  std::array<double, 2> PoleErrors = { { 0.0, 0.0 } };

  /// The direction up.
  std::array<double, 3> GetUp(double x, double y) const
  {
    GlobeShape::Vertex vertex;
    vertex.Up = { { 0.0, 0.0, 1.0 } };
    if (this->Globe)
    {
      this->Globe->Locate(1, &x, &y, &vertex);
    }
    return vertex.Up;
  }

  std::array<double, 3> ToWorld(double x, double y, double height) const
  {
    if (this->Globe)
    {
      GlobeShape::Vertex vertex;
      this->Globe->Locate(1, &x, &y, &vertex);
      return vertex.ToWorld(height * this->HeightScale, this->Exaggeration);
    }
    return { { this->Origin[0] + x * this->Column[0] + y * this->Row[0],
      this->Origin[1] + x * this->Column[1] + y * this->Row[1], height * this->HeightScale } };
  }
};
}

#endif
