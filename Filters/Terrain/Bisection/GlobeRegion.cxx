// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Bisection/GlobeRegion.h"

#include "Bisection/AdaptiveTerrain.h"
#include "Bisection/ClosedLattice.h"
#include "Geodesy/GlobeShape.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace relevo
{
namespace
{
// The geoid is curved more than the ellipsoid in some parts.
constexpr double GeoidGrowth = 2.0;
}

GlobeRegion::GlobeRegion(
  const AdaptiveTerrain& terrain, double exaggeration, int level, int column, int row)
  : Terrain(terrain)
  , Placement(terrain.GetPlacement(exaggeration))
  , Exaggeration(std::max(1.0, std::abs(exaggeration)))
  , Size(std::ldexp(1.0, level))
  , First{ column * this->Size, row * this->Size }
{
}

void GlobeRegion::SetPole(std::vector<float>& heights, int width, int row, float height) const
{
  if (!std::isnan(height))
  {
    std::fill_n(heights.begin() + static_cast<std::ptrdiff_t>(row) * width, width, height);
  }
}

void GlobeRegion::Close(
  std::vector<float>& heights, int& width, int& height, double columns[2], double rows[2])
{
  const GlobeShape& globe = *this->Placement.Globe;
  const RasterDescription& contents = this->Terrain.GetLattice().Describe();
  const double period = globe.GetPeriod();
  const std::array<float, 2>& poles = this->Terrain.GetClosed()->GetPoles();
  if (period > 0.0 && columns[0] == 0.0 && columns[1] == period - 1.0 &&
    std::fmod(period, this->Size) == 0.0)
  {
    const int wider = static_cast<int>(period / this->Size) + 1;
    std::vector<float> closed(static_cast<std::size_t>(wider) * height);
    for (int i = 0; i < height; ++i)
    {
      const auto from = heights.begin() + static_cast<std::ptrdiff_t>(i) * width;
      const auto to = closed.begin() + static_cast<std::ptrdiff_t>(i) * wider;
      std::copy_n(from, std::min(width, wider - 1), to);
      to[wider - 1] = *from;
    }
    heights.swap(closed);
    width = wider;
    columns[1] = period;
  }
  const double end = globe.GetEnd()[1];
  const bool isAtEnd = rows[1] == contents.Height - 1.0;
  if (isAtEnd && end > rows[1] && !std::isnan(poles[1]) && std::fmod(end, this->Size) == 0.0)
  {
    height = static_cast<int>((end - this->First[1]) / this->Size) + 1;
    heights.resize(static_cast<std::size_t>(width) * height);
    rows[1] = end;
  }
  if (rows[0] == 0.0)
  {
    this->SetPole(heights, width, 0, poles[0]);
  }
  if (rows[1] == end)
  {
    this->SetPole(heights, width, height - 1, poles[1]);
  }
  double highest = 0.0;
  for (const float value : heights)
  {
    highest = value > highest ? value : highest; // false for NaN
  }
  const GeocentricFrame& frame = globe.GetFrame();
  const double radius = frame.GetSemiMajorAxis() * (1.0 - 2.0 * frame.GetFlattening());
  this->Growth = (globe.GetGeoid().HasGeoid() ? GeoidGrowth : 1.0) *
    (1.0 + highest * std::abs(this->Placement.HeightScale) / radius);
}

double GlobeRegion::GetShapeError(const LatticeDecimation::Bounds& bounds) const
{
  const GlobeShape& globe = *this->Placement.Globe;
  std::array<double, 2> ranges[2];
  std::array<double, 2> size;
  for (int axis = 0; axis < 2; ++axis)
  {
    const double end = globe.GetEnd()[axis];
    for (int i = 0; i < 2; ++i)
    {
      ranges[axis][i] = std::clamp(this->First[axis] + bounds[axis][i] * this->Size, 0.0, end);
    }
    size[axis] = (bounds[axis][1] - bounds[axis][0]) * this->Size;
  }
  const bool isFirst = ranges[1][0] < 1.0 && this->HasPole(0);
  const bool isLast = ranges[1][1] > globe.GetEnd()[1] - 1.0 && this->HasPole(1);
  double closing = 0.0;
  if (isFirst || isLast)
  {
    // Rows are moved there, so that triangles must not be larger than cells.
    closing = (isFirst ? this->Placement.PoleErrors[0] : 0.0) +
      (isLast ? this->Placement.PoleErrors[1] : 0.0);
    closing = size[1] > this->Size ? std::numeric_limits<double>::infinity()
                                   : closing * std::pow(size[1] / this->Size, 2);
  }
  return this->ToHeight(
           globe.GetBounds(ranges[0], ranges[1]).GetDistance(size, this->Exaggeration)) +
    closing;
}

bool GlobeRegion::HasPole(int end) const
{
  return !std::isnan(this->Terrain.GetClosed()->GetPoles()[end]);
}

double GlobeRegion::GetShapeErrorOfCell() const
{
  const GlobeShape& globe = *this->Placement.Globe;
  const std::array<double, 2>& end = globe.GetEnd();
  const GlobeShape::Bounds bounds = globe.GetBounds({ { 0.0, end[0] } }, { { 0.0, end[1] } });
  return this->ToHeight(bounds.GetDistance({ { this->Size, this->Size } }, this->Exaggeration)) +
    std::max(this->Placement.PoleErrors[0], this->Placement.PoleErrors[1]);
}

// In the unit of the heights, before the exaggeration.
double GlobeRegion::ToHeight(double distance) const
{
  const double unit = this->Terrain.GetLattice().Describe().VerticalUnit;
  return this->Growth * distance / (unit * this->Exaggeration);
}
}
