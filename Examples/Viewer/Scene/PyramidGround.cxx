// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/PyramidGround.h"

#include "Lattice/HeightLattice.h"

#include "vtkBox.h"
#include "vtkCamera.h"
#include "vtkPoints.h"
#include "vtkTerrainPyramid.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace
{
// Distances in samples up to which samples are read.
constexpr double NearSamples = 16.0;
// Larger rasters without overviews are not read for an outline.
constexpr int LargestOutline = 2048;
}

//------------------------------------------------------------------------------
PyramidGround::PyramidGround(vtkTerrainPyramid* pyramid)
  : Pyramid(pyramid)
  , Lattice(pyramid->GetLattice())
  , Frame(this->Lattice->Describe().Location)
{
  this->SetExaggeration(1.0);
}

//------------------------------------------------------------------------------
PyramidGround::~PyramidGround() = default;

//------------------------------------------------------------------------------
void PyramidGround::SetExaggeration(double factor)
{
  const relevo::RasterDescription& contents = this->Lattice->Describe();
  this->Placement =
    this->Frame.GetPlacement(contents.Width, contents.Height, contents.VerticalUnit * factor);
}

//------------------------------------------------------------------------------
std::array<double, 2> PyramidGround::ToSamples(double x, double y) const
{
  const relevo::TerrainPlacement& place = this->Placement;
  const double area = place.Column[0] * place.Row[1] - place.Column[1] * place.Row[0];
  const double dx = x - place.Origin[0];
  const double dy = y - place.Origin[1];
  return { { (dx * place.Row[1] - dy * place.Row[0]) / area,
    (dy * place.Column[0] - dx * place.Column[1]) / area } };
}

//------------------------------------------------------------------------------
double PyramidGround::GetElevation(double x, double y)
{
  const std::array<double, 2> coordinates = this->Frame.ToCoordinates({ { x, y } });
  return this->Pyramid->GetElevation(coordinates[0], coordinates[1]);
}

//------------------------------------------------------------------------------
bool PyramidGround::GetHeight(double x, double y, double& height)
{
  height = this->GetElevation(x, y);
  if (std::isnan(height))
  {
    height = this->GetNearSample({ { x, y } });
  }
  return !std::isnan(height);
}

//------------------------------------------------------------------------------
double PyramidGround::GetNearSample(const std::array<double, 2>& place)
{
  const double reach = 0.1; // samples, for rounded coordinates
  const std::array<double, 2> samples = this->ToSamples(place[0], place[1]);
  const double column = std::round(samples[0]);
  const double row = std::round(samples[1]);
  const relevo::RasterDescription& contents = this->Lattice->Describe();
  float height = 0.0f;
  std::string error;
  const bool isNear = std::abs(samples[0] - column) <= reach &&
    std::abs(samples[1] - row) <= reach && column >= 0.0 && row >= 0.0 && column < contents.Width &&
    row < contents.Height;
  return isNear &&
      this->Lattice->ReadWindow(
        0, static_cast<int>(column), static_cast<int>(row), 1, 1, &height, error)
    ? height
    : std::nan("");
}

//------------------------------------------------------------------------------
double PyramidGround::GetZ(double height)
{
  return this->Placement.HeightScale * height;
}

//------------------------------------------------------------------------------
bool PyramidGround::GetHighestGround(double x, double y, double spacing, double& z)
{
  const double length = std::hypot(this->Placement.Column[0], this->Placement.Column[1]);
  if (spacing <= NearSamples * length)
  {
    z = this->GetZ(this->GetElevation(x, y));
    return !std::isnan(z);
  }
  const std::array<double, 2> samples = this->ToSamples(x, y);
  const double reach = 0.5 * spacing / length;
  const relevo::RasterDescription& contents = this->Lattice->Describe();
  std::array<std::array<double, 2>, 2> window;
  for (int axis = 0; axis < 2; ++axis)
  {
    const double last = (axis == 0 ? contents.Width : contents.Height) - 1.0;
    if (samples[axis] < 0.0 || samples[axis] > last)
    {
      return false;
    }
    window[axis] = { { std::max(samples[axis] - reach, 0.0),
      std::min(samples[axis] + reach, last) } };
  }
  // One tile and its neighbors.
  const double tiles = 2.0 * reach / relevo::ElevationRanges::SamplesPerTile;
  const int level = std::max(0, static_cast<int>(std::ceil(std::log2(std::max(tiles, 1.0)))));
  const auto range = this->Lattice->GetRanges()->Get(level, window[0], window[1]);
  z = this->GetZ(range[1]);
  return range[0] <= range[1];
}

//------------------------------------------------------------------------------
void PyramidGround::MoveOnto(double place[2])
{
  const relevo::RasterDescription& contents = this->Lattice->Describe();
  const std::array<double, 2> samples = this->ToSamples(place[0], place[1]);
  const std::array<double, 3> nearest =
    this->Placement.ToWorld(std::clamp(samples[0], 0.0, contents.Width - 1.0),
      std::clamp(samples[1], 0.0, contents.Height - 1.0), 0.0);
  std::copy_n(nearest.begin(), 2, place);
}

//------------------------------------------------------------------------------
std::array<double, 4> PyramidGround::GetExtent()
{
  const relevo::RasterDescription& contents = this->Lattice->Describe();
  std::array<double, 4> extent;
  for (int corner = 0; corner < 4; ++corner)
  {
    const std::array<double, 3> place = this->Placement.ToWorld(
      corner % 2 * contents.Width - 0.5, corner / 2 * contents.Height - 0.5, 0.0);
    for (int axis = 0; axis < 2; ++axis)
    {
      double& lowest = extent[2 * axis];
      double& highest = extent[2 * axis + 1];
      lowest = corner == 0 ? place[axis] : std::min(lowest, place[axis]);
      highest = corner == 0 ? place[axis] : std::max(highest, place[axis]);
    }
  }
  return extent;
}

//------------------------------------------------------------------------------
bool PyramidGround::HasCoordinateSystem()
{
  return !this->Lattice->Describe().Location.WKT.empty();
}

//------------------------------------------------------------------------------
bool PyramidGround::IsGeographic()
{
  return this->Lattice->Describe().Location.System == relevo::Georeference::Kind::Geographic;
}

//------------------------------------------------------------------------------
bool PyramidGround::CountsSamples() const
{
  return this->Lattice->Describe().Location.System == relevo::Georeference::Kind::None;
}

//------------------------------------------------------------------------------
double PyramidGround::GetVerticalUnit()
{
  return this->Lattice->Describe().VerticalUnit;
}

//------------------------------------------------------------------------------
bool PyramidGround::ToRaster(const double place[2], double coordinates[2])
{
  const std::array<double, 2> converted = this->Frame.ToCoordinates({ { place[0], place[1] } });
  std::copy(converted.begin(), converted.end(), coordinates);
  return true;
}

//------------------------------------------------------------------------------
bool PyramidGround::FromRaster(const double coordinates[2], double place[2])
{
  const std::array<double, 2> converted = this->Frame.ToMap({ { coordinates[0], coordinates[1] } });
  std::copy(converted.begin(), converted.end(), place);
  return true;
}

//------------------------------------------------------------------------------
bool PyramidGround::FromDegrees(const double degrees[2], double place[2])
{
  double coordinates[2];
  return this->Pyramid->GeographicToRaster(degrees, coordinates) &&
    this->FromRaster(coordinates, place);
}

//------------------------------------------------------------------------------
bool PyramidGround::ToDegrees(const double place[2], double degrees[2])
{
  double coordinates[2];
  return !this->IsGeographic() && this->ToRaster(place, coordinates) &&
    this->Pyramid->RasterToGeographic(coordinates, degrees);
}

//------------------------------------------------------------------------------
void PyramidGround::AddOutline(vtkPoints* points)
{
  const int intervals = 64;
  const relevo::RasterDescription& contents = this->Lattice->Describe();
  const int side = std::max(contents.Width, contents.Height);
  int coarsest[2];
  this->Pyramid->GetLevelDimensions(this->Pyramid->GetNumberOfLevels() - 1, coarsest);
  int level = 0;
  while (side >> level > intervals)
  {
    ++level;
  }
  const int columns = ((contents.Width - 1) >> level) + 1;
  const int rows = ((contents.Height - 1) >> level) + 1;
  std::vector<float> heights(static_cast<std::size_t>(columns) * rows);
  std::string error;
  const bool isRead = std::max(coarsest[0], coarsest[1]) <= LargestOutline &&
    this->Lattice->ReadWindow(level, 0, 0, columns, rows, heights.data(), error);
  for (int i = 0; isRead && i < columns * rows; ++i)
  {
    if (std::isfinite(heights[i]))
    {
      const double column = static_cast<double>(i % columns) * (1 << level);
      const double row = static_cast<double>(i / columns) * (1 << level);
      points->InsertNextPoint(this->Placement.ToWorld(column, row, heights[i]).data());
    }
  }
  // The last vertices may be before the borders. Rasters that are not read are in a box.
  const bool isBox = points->GetNumberOfPoints() == 0;
  double range[2];
  this->Pyramid->GetRange(range);
  for (int corner = 0; corner < 8; ++corner)
  {
    const std::array<double, 3> point =
      this->Placement.ToWorld(corner % 2 == 0 ? 0.0 : contents.Width - 1.0,
        corner / 2 % 2 == 0 ? 0.0 : contents.Height - 1.0, range[corner / 4]);
    double height;
    if (isBox)
    {
      points->InsertNextPoint(point.data());
    }
    else if (corner < 4 && this->GetHeight(point[0], point[1], height))
    {
      points->InsertNextPoint(point[0], point[1], this->GetZ(height));
    }
  }
}

//------------------------------------------------------------------------------
std::optional<std::array<double, 3>> PyramidGround::FindFirst(
  vtkCamera* camera, const double bounds[6])
{
  double beyond[3];
  for (int i = 0; i < 3; ++i)
  {
    beyond[i] = camera->GetPosition()[i] +
      camera->GetClippingRange()[1] * camera->GetDirectionOfProjection()[i];
  }
  double box[6];
  std::copy_n(bounds, 6, box);
  const double margin = 1e-6 * (box[1] - box[0] + box[3] - box[2]);
  box[4] -= margin;
  box[5] += margin;
  double ends[2];
  double from[3];
  double to[3];
  int planes[2];
  return vtkBox::IntersectWithLine(
           box, camera->GetPosition(), beyond, ends[0], ends[1], from, to, planes[0], planes[1])
    ? this->Intersect(from, to)
    : std::nullopt;
}

//------------------------------------------------------------------------------
std::optional<std::array<double, 3>> PyramidGround::Intersect(
  const double from[3], const double to[3])
{
  const int steps = 1000;
  const int halvings = 20;
  const auto interpolate = [&](double t) -> std::array<double, 3>
  {
    return { { from[0] + t * (to[0] - from[0]), from[1] + t * (to[1] - from[1]),
      from[2] + t * (to[2] - from[2]) } };
  };
  const auto getDistance = [&](double t)
  {
    const std::array<double, 3> point = interpolate(t);
    double height;
    return this->GetHeight(point[0], point[1], height) ? point[2] - this->GetZ(height)
                                                       : std::nan("");
  };
  double last = std::nan("");
  for (int i = 0; i <= steps; ++i)
  {
    double end = static_cast<double>(i) / steps;
    const double distance = getDistance(end);
    if (last > 0.0 && distance <= 0.0)
    {
      double begin = end - 1.0 / steps;
      for (int halving = 0; halving < halvings; ++halving)
      {
        const double middle = 0.5 * (begin + end);
        (getDistance(middle) > 0.0 ? begin : end) = middle;
      }
      return interpolate(end);
    }
    last = distance;
  }
  return std::nullopt;
}
