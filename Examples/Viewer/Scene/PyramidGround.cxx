// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/PyramidGround.h"

#include "vtkBox.h"
#include "vtkCamera.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkTerrainMapper.h"
#include "vtkTerrainPyramid.h"

#include <algorithm>
#include <cmath>

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
{
  pyramid->GetDimensions(this->Size);
  this->Map->SetPyramid(pyramid);
  const auto locate = [this](double column, double row)
  {
    const double samples[2] = { column, row };
    double raster[2];
    std::array<double, 2> place{};
    this->Pyramid->SampleToRaster(samples, raster);
    this->FromRaster(raster, place.data());
    return place;
  };
  this->Origin = locate(0.0, 0.0);
  const std::array<double, 2> lastColumn = locate(this->Size[0], 0.0);
  const std::array<double, 2> lastRow = locate(0.0, this->Size[1]);
  for (int axis = 0; axis < 2; ++axis)
  {
    this->Column[axis] = (lastColumn[axis] - this->Origin[axis]) / this->Size[0];
    this->Row[axis] = (lastRow[axis] - this->Origin[axis]) / this->Size[1];
  }
}

//------------------------------------------------------------------------------
PyramidGround::~PyramidGround() = default;

//------------------------------------------------------------------------------
void PyramidGround::SetExaggeration(double factor)
{
  this->Map->SetExaggeration(factor);
}

//------------------------------------------------------------------------------
std::array<double, 2> PyramidGround::ToSamples(double x, double y) const
{
  const double area = this->Column[0] * this->Row[1] - this->Column[1] * this->Row[0];
  const double dx = x - this->Origin[0];
  const double dy = y - this->Origin[1];
  return { { (dx * this->Row[1] - dy * this->Row[0]) / area,
    (dy * this->Column[0] - dx * this->Column[1]) / area } };
}

//------------------------------------------------------------------------------
std::array<double, 2> PyramidGround::FromSamples(double column, double row) const
{
  return { { this->Origin[0] + column * this->Column[0] + row * this->Row[0],
    this->Origin[1] + column * this->Column[1] + row * this->Row[1] } };
}

//------------------------------------------------------------------------------
double PyramidGround::GetElevation(double x, double y)
{
  const double place[2] = { x, y };
  double coordinates[2];
  this->ToRaster(place, coordinates);
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
  double coordinates[2];
  this->ToRaster(place.data(), coordinates);
  return std::abs(samples[0] - std::round(samples[0])) <= reach &&
      std::abs(samples[1] - std::round(samples[1])) <= reach
    ? this->Pyramid->GetNearestElevation(coordinates[0], coordinates[1])
    : std::nan("");
}

//------------------------------------------------------------------------------
double PyramidGround::GetZ(double height)
{
  return this->Pyramid->GetVerticalUnit() * this->Map->GetExaggeration() * height;
}

//------------------------------------------------------------------------------
bool PyramidGround::GetHighestGround(double x, double y, double spacing, double& z)
{
  if (spacing <= NearSamples * std::hypot(this->Column[0], this->Column[1]))
  {
    z = this->GetZ(this->GetElevation(x, y));
    return !std::isnan(z);
  }
  const double reach = 0.5 * spacing;
  const double ends[2][2] = { { x - reach, y - reach }, { x + reach, y + reach } };
  double corners[2][2];
  double region[4];
  const std::array<double, 2> samples = this->ToSamples(x, y);
  if (samples[0] < 0.0 || samples[1] < 0.0 || samples[0] > this->Size[0] - 1.0 ||
    samples[1] > this->Size[1] - 1.0)
  {
    return false;
  }
  this->ToRaster(ends[0], corners[0]);
  this->ToRaster(ends[1], corners[1]);
  for (int axis = 0; axis < 2; ++axis)
  {
    region[2 * axis] = std::min(corners[0][axis], corners[1][axis]);
    region[2 * axis + 1] = std::max(corners[0][axis], corners[1][axis]);
  }
  double range[2];
  if (!this->Pyramid->GetRangeOfRegion(region, range))
  {
    return false;
  }
  z = this->GetZ(range[1]);
  return true;
}

//------------------------------------------------------------------------------
void PyramidGround::MoveOnto(double place[2])
{
  const std::array<double, 2> samples = this->ToSamples(place[0], place[1]);
  const std::array<double, 2> nearest =
    this->FromSamples(std::clamp(samples[0], 0.0, this->Size[0] - 1.0),
      std::clamp(samples[1], 0.0, this->Size[1] - 1.0));
  std::copy(nearest.begin(), nearest.end(), place);
}

//------------------------------------------------------------------------------
std::array<double, 4> PyramidGround::GetExtent()
{
  std::array<double, 4> extent;
  for (int corner = 0; corner < 4; ++corner)
  {
    const std::array<double, 2> place =
      this->FromSamples(corner % 2 * this->Size[0] - 0.5, corner / 2 * this->Size[1] - 0.5);
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
  return *this->Pyramid->GetCoordinateSystem() != '\0';
}

//------------------------------------------------------------------------------
bool PyramidGround::IsGeographic()
{
  return this->Pyramid->IsGeographic();
}

//------------------------------------------------------------------------------
bool PyramidGround::CountsSamples() const
{
  return !this->Pyramid->HasGeoreference();
}

//------------------------------------------------------------------------------
double PyramidGround::GetVerticalUnit()
{
  return this->Pyramid->GetVerticalUnit();
}

//------------------------------------------------------------------------------
bool PyramidGround::ToRaster(const double place[2], double coordinates[2])
{
  const double world[3] = { place[0], place[1], 0.0 };
  double raster[3];
  const bool isConverted = this->Map->WorldToRaster(world, raster);
  std::copy_n(raster, isConverted ? 2 : 0, coordinates);
  return isConverted;
}

//------------------------------------------------------------------------------
bool PyramidGround::FromRaster(const double coordinates[2], double place[2])
{
  const double raster[3] = { coordinates[0], coordinates[1], 0.0 };
  double world[3];
  const bool isConverted = this->Map->RasterToWorld(raster, world);
  std::copy_n(world, isConverted ? 2 : 0, place);
  return isConverted;
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
  int coarsest[2];
  this->Pyramid->GetLevelDimensions(this->Pyramid->GetNumberOfLevels() - 1, coarsest);
  if (std::max(coarsest[0], coarsest[1]) <= LargestOutline)
  {
    const auto image =
      vtkSmartPointer<vtkImageData>::Take(this->Pyramid->GetReducedElevations(intervals + 1));
    for (vtkIdType i = 0; image && i < image->GetNumberOfPoints(); ++i)
    {
      const double height = image->GetPointData()->GetScalars()->GetComponent(i, 0);
      const double* samples = image->GetPoint(i);
      if (std::isfinite(height))
      {
        const std::array<double, 2> place = this->FromSamples(samples[0], samples[1]);
        points->InsertNextPoint(place[0], place[1], this->GetZ(height));
      }
    }
  }
  // The last vertices may be before the borders. Rasters that are not read are in a box.
  const bool isBox = points->GetNumberOfPoints() == 0;
  double range[2];
  this->Pyramid->GetRange(range);
  for (int corner = 0; corner < 8; ++corner)
  {
    const std::array<double, 2> point = this->FromSamples(
      corner % 2 == 0 ? 0.0 : this->Size[0] - 1.0, corner / 2 % 2 == 0 ? 0.0 : this->Size[1] - 1.0);
    double height;
    if (isBox)
    {
      points->InsertNextPoint(point[0], point[1], this->GetZ(range[corner / 4]));
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
