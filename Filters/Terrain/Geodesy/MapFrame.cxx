// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Geodesy/MapFrame.h"

#include <algorithm>
#include <cmath>

namespace relevo
{
namespace
{
constexpr double RadiansPerDegree = 3.14159265358979323846 / 180.0;

// Rasters around a pole get a width all the same.
constexpr double MinimumCosine = 1e-3;
}

MapFrame::MapFrame(const Georeference& location)
  : Location(location)
  , Center(location.Coordinates(0.5, 0.5))
  , Lengths{ { location.Unit, location.Unit } }
{
  if (location.System == Georeference::Kind::Geographic)
  {
    // The radii of curvature along the parallel and the meridian.
    const double latitude = this->Center[1] * location.Unit * RadiansPerDegree;
    const double squared = location.Flattening * (2.0 - location.Flattening);
    const double root = std::sqrt(1.0 - squared * std::pow(std::sin(latitude), 2));
    const double across = location.SemiMajorAxis / root;
    const double along = across * (1.0 - squared) / (root * root);
    const double unit = location.Unit * RadiansPerDegree;
    this->Lengths = { { unit * across * std::max(MinimumCosine, std::cos(latitude)),
      unit * along } };
  }
}

std::array<double, 2> MapFrame::ToMap(const std::array<double, 2>& coordinates) const
{
  return { { (coordinates[0] - this->Center[0]) * this->Lengths[0],
    (coordinates[1] - this->Center[1]) * this->Lengths[1] } };
}

std::array<double, 2> MapFrame::ToCoordinates(const std::array<double, 2>& map) const
{
  return { { this->Center[0] + map[0] / this->Lengths[0],
    this->Center[1] + map[1] / this->Lengths[1] } };
}

TerrainPlacement MapFrame::GetPlacement(int columns, int rows, double heightScale) const
{
  const auto place = [&](double column, double row)
  {
    const double u = (column + 0.5) / columns;
    const double v = (row + 0.5) / rows;
    return this->ToMap(this->Location.Coordinates(
      this->Location.FlipColumns ? 1.0 - u : u, this->Location.FlipRows ? 1.0 - v : v));
  };
  TerrainPlacement placement;
  placement.HeightScale = heightScale;
  placement.Origin = place(0.0, 0.0);
  const std::array<double, 2> nextColumn = place(columns, 0.0);
  const std::array<double, 2> nextRow = place(0.0, rows);
  for (int axis = 0; axis < 2; ++axis)
  {
    placement.Column[axis] = (nextColumn[axis] - placement.Origin[axis]) / columns;
    placement.Row[axis] = (nextRow[axis] - placement.Origin[axis]) / rows;
  }
  return placement;
}
}
