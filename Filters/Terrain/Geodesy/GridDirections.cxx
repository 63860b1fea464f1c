// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Geodesy/GridDirections.h"

#include "Geodesy/CoordinateSystem.h"
#include "Geodesy/GDALSession.h"
#include "vtkSMPThreadLocal.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace relevo
{
namespace
{
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr double Step = 50.0;           // metres on each side of a central difference
constexpr double LargestTurn = 0.01;    // radians of longitude, limits the difference near the
                                        // poles
constexpr double SmallestRadius = 0.01; // metres, of the smallest parallel where east is defined
constexpr double CutRatio = 100.0;      // between the two halves of a difference at a cut of the
                                        // grid
constexpr int PlacesAtOnce = 1024;

struct TransformationFreer
{
  void operator()(OGRCoordinateTransformationH transformation) const
  {
    OCTDestroyCoordinateTransformation(transformation);
  }
};
using Transformation =
  std::unique_ptr<std::remove_pointer_t<OGRCoordinateTransformationH>, TransformationFreer>;

// Coordinates of many positions; NaN outside of the map.
struct Coordinates
{
  explicit Coordinates(std::size_t count)
    : X(count)
    , Y(count)
  {
  }

  void Transform(OGRCoordinateTransformationH transformation)
  {
    std::vector<int> success(this->X.size(), 0);
    OCTTransformEx(transformation, static_cast<int>(this->X.size()), this->X.data(), this->Y.data(),
      nullptr, success.data());
    for (std::size_t i = 0; i < success.size(); ++i)
    {
      if (!success[i] || !std::isfinite(this->X[i]) || !std::isfinite(this->Y[i]))
      {
        this->X[i] = this->Y[i] = NaN;
      }
    }
  }

  std::vector<double> X;
  std::vector<double> Y;
};

// Radii of curvature in metres at a latitude in radians.
struct Curvature
{
  Curvature(const Georeference& system, double latitude)
  {
    const double e2 = system.Flattening * (2.0 - system.Flattening);
    const double s = std::sin(latitude);
    const double w2 = 1.0 - e2 * s * s;
    this->Parallel = system.SemiMajorAxis * std::cos(latitude) / std::sqrt(w2);
    this->Meridian = system.SemiMajorAxis * (1.0 - e2) / (w2 * std::sqrt(w2));
  }

  double Parallel;
  double Meridian;
};

// The difference between both sides. If the grid is cut between them, as at the antimeridian, one
// half is very long, and the result is twice the other half.
MapPlace difference(const Coordinates& sides, int low, const MapPlace& centre, double scale)
{
  const double lower[2] = { centre[0] - sides.X[low], centre[1] - sides.Y[low] };
  const double upper[2] = { sides.X[low + 1] - centre[0], sides.Y[low + 1] - centre[1] };
  const double lowerLength = std::hypot(lower[0], lower[1]);
  const double upperLength = std::hypot(upper[0], upper[1]);
  const bool isCut = std::max(lowerLength, upperLength) >
    CutRatio * std::min(lowerLength, upperLength) + CutRatio * Step;
  const double shareOfLower = !isCut ? 1.0 : lowerLength < upperLength ? 2.0 : 0.0;
  const double shareOfUpper = 2.0 - shareOfLower;
  return { scale * (shareOfLower * lower[0] + shareOfUpper * upper[0]),
    scale * (shareOfLower * lower[1] + shareOfUpper * upper[1]) };
}
}

struct GridDirections::Projection
{
  SpatialReference Grid;
  SpatialReference Geographic;
  Transformation ToGeographic;
  Transformation ToGrid;
  double Radians = 1.0; // radians per unit of longitude and latitude

  explicit Projection(const std::string& definition)
    : Grid(NewSpatialReference(definition))
  {
    if (!this->Grid)
    {
      return;
    }
    this->Geographic.reset(OSRCloneGeogCS(this->Grid.get()));
    if (!this->Geographic)
    {
      return;
    }
    OSRSetAxisMappingStrategy(this->Geographic.get(), OAMS_TRADITIONAL_GIS_ORDER);
    this->Radians = OSRGetAngularUnits(this->Geographic.get(), nullptr);
    this->ToGeographic.reset(
      OCTNewCoordinateTransformation(this->Grid.get(), this->Geographic.get()));
    this->ToGrid.reset(OCTNewCoordinateTransformation(this->Geographic.get(), this->Grid.get()));
  }

  bool IsValid() const { return this->ToGeographic && this->ToGrid; }
};

GridDirections::GridDirections(
  const std::string& definition, const Georeference& system, const MapPlace& origin)
  : Definition(definition)
  , System(system)
  , Origin(origin)
{
}

GridDirections::~GridDirections() = default;

bool GridDirections::IsValid() const
{
  return Projection(this->Definition).IsValid();
}

void GridDirections::Evaluate(const std::vector<MapPlace>& places, std::vector<MapAxes>& axes) const
{
  axes.assign(places.size(), { { NaN, NaN }, { NaN, NaN } });
  // A transformation must not be shared by threads.
  vtkSMPThreadLocal<std::shared_ptr<Projection>> projections;
  vtkSMPTools::For(0, static_cast<vtkIdType>(places.size()), PlacesAtOnce,
    [&](vtkIdType begin, vtkIdType end)
    {
      GDALSession session; // suppresses messages; failures become NaN
      std::shared_ptr<Projection>& projection = projections.Local();
      if (!projection)
      {
        projection = std::make_shared<Projection>(this->Definition);
      }
      for (vtkIdType i = begin; projection->IsValid() && i < end; i += PlacesAtOnce)
      {
        const int count = static_cast<int>(std::min<vtkIdType>(PlacesAtOnce, end - i));
        this->EvaluateSome(*projection, &places[i], &axes[i], count);
      }
    });
}

void GridDirections::EvaluateSome(
  Projection& projection, const MapPlace* places, MapAxes* axes, int count) const
{
  Coordinates centres(count);
  for (int i = 0; i < count; ++i)
  {
    centres.X[i] = this->Origin[0] + places[i][0] / this->System.Unit;
    centres.Y[i] = this->Origin[1] + places[i][1] / this->System.Unit;
  }
  Coordinates geographic = centres;
  geographic.Transform(projection.ToGeographic.get());

  // Points to the west, east, south and north of each position, and their distances in metres.
  Coordinates sides(4 * static_cast<std::size_t>(count));
  std::vector<std::array<double, 2>> spans(count);
  const double pole = 0.5 * M_PI;
  for (int i = 0; i < count; ++i)
  {
    const double longitude = geographic.X[i];
    const double latitude = geographic.Y[i] * projection.Radians;
    const Curvature curvature(this->System, latitude);
    const double turn = std::min(Step / curvature.Parallel, LargestTurn);
    const double south = std::max(latitude - Step / curvature.Meridian, -pole);
    const double north = std::min(latitude + Step / curvature.Meridian, pole);
    const double x[4] = { -turn, turn, 0.0, 0.0 };
    const double y[4] = { latitude, latitude, south, north };
    for (int side = 0; side < 4; ++side)
    {
      sides.X[4 * i + side] = longitude + x[side] / projection.Radians;
      sides.Y[4 * i + side] = y[side] / projection.Radians;
    }
    const bool hasEast = curvature.Parallel > SmallestRadius;
    spans[i] = { hasEast ? 2.0 * turn * curvature.Parallel : NaN,
      (north - south) * curvature.Meridian };
  }
  sides.Transform(projection.ToGrid.get());

  for (int i = 0; i < count; ++i)
  {
    const MapPlace centre = { centres.X[i], centres.Y[i] };
    axes[i] = { difference(sides, 4 * i, centre, this->System.Unit / spans[i][0]),
      difference(sides, 4 * i + 2, centre, this->System.Unit / spans[i][1]) };
  }
}
}
