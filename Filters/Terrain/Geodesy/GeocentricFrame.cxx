// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Geodesy/GeocentricFrame.h"

#if RELEVO_HAS_GDAL
#include "Geodesy/CoordinateSystem.h"
#include "Geodesy/GDALSession.h"
#endif

#include <GeographicLib/Geocentric.hpp>
#include <GeographicLib/Math.hpp>

#include <cmath>
#include <limits>
#include <mutex>
#include <utility>
#include <vector>

namespace relevo
{
#if RELEVO_HAS_GDAL
namespace
{
struct ProjectionFreer
{
  void operator()(void* projection) const { OCTDestroyCoordinateTransformation(projection); }
};
using Projection = std::unique_ptr<void, ProjectionFreer>;
}

// Projections from the coordinate system to longitude and latitude, each for one thread at a time.
struct GeocentricFrame::Projections
{
  explicit Projections(const std::string& definition)
    : Definition(definition)
  {
    GDALSession session;
    const SpatialReference system = NewSpatialReference(definition);
    const SpatialReference geographic(system ? OSRCloneGeogCS(system.get()) : nullptr);
    if (geographic)
    {
      this->Unit = OSRGetAngularUnits(geographic.get(), nullptr) / GeographicLib::Math::degree();
    }
  }

  Projection Take()
  {
    {
      const std::lock_guard<std::mutex> lock(this->Mutex);
      if (!this->Free.empty())
      {
        Projection projection = std::move(this->Free.back());
        this->Free.pop_back();
        return projection;
      }
    }
    const SpatialReference system = NewSpatialReference(this->Definition);
    if (!system || OSRIsLocal(system.get()))
    {
      return nullptr;
    }
    const SpatialReference geographic(OSRCloneGeogCS(system.get()));
    if (!geographic)
    {
      return nullptr;
    }
    OSRSetAxisMappingStrategy(geographic.get(), OAMS_TRADITIONAL_GIS_ORDER);
    return Projection(OCTNewCoordinateTransformation(system.get(), geographic.get()));
  }

  void Return(Projection projection)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Free.push_back(std::move(projection));
  }

  void Convert(std::size_t number, double* x, double* y)
  {
    GDALSession session;
    constexpr double missing = std::numeric_limits<double>::quiet_NaN();
    Projection projection = this->Take();
    std::vector<int> success(number, 0);
    if (projection)
    {
      OCTTransformEx(projection.get(), static_cast<int>(number), x, y, nullptr, success.data());
    }
    for (std::size_t i = 0; i < number; ++i)
    {
      const bool isValid = success[i] != 0 && std::isfinite(x[i]) && std::isfinite(y[i]);
      x[i] = isValid ? x[i] * this->Unit : missing;
      y[i] = isValid ? y[i] * this->Unit : missing;
    }
    if (projection)
    {
      this->Return(std::move(projection));
    }
  }

  std::string Definition;
  double Unit = 1.0; // degrees per unit of longitude and latitude
  std::mutex Mutex;
  std::vector<Projection> Free;
};
#else
struct GeocentricFrame::Projections
{
};
#endif

GeocentricFrame::GeocentricFrame(const Georeference& location)
  : Location(location)
{
  const std::string missing =
    " has no coordinate system that relates it to an ellipsoid, which "
    "the geocentric frame needs. Give the file one (gdal_translate -a_srs), "
    "or use the map frame.";
  if (location.System == Georeference::Kind::Geographic)
  {
    return;
  }
  if (location.System != Georeference::Kind::Planar || location.WKT.empty())
  {
    this->Error = missing;
    return;
  }
#if RELEVO_HAS_GDAL
  this->Pool = std::make_unique<Projections>(location.WKT);
  GDALSession session;
  Projection projection = this->Pool->Take();
  if (projection)
  {
    this->Pool->Return(std::move(projection));
  }
  else
  {
    this->Error = missing;
  }
#else
  this->Error = missing;
#endif
}

GeocentricFrame::~GeocentricFrame() = default;

void GeocentricFrame::ToAngles(std::size_t number, double* x, double* y) const
{
#if RELEVO_HAS_GDAL
  if (this->Pool)
  {
    this->Pool->Convert(number, x, y);
    return;
  }
#endif
  for (std::size_t i = 0; i < number; ++i)
  {
    x[i] *= this->Location.Unit;
    y[i] *= this->Location.Unit;
  }
}

GeocentricFrame::Place GeocentricFrame::GetPlace(double longitude, double latitude) const
{
  double sinLongitude;
  double cosLongitude;
  double sinLatitude;
  double cosLatitude;
  GeographicLib::Math::sincosd(longitude, sinLongitude, cosLongitude);
  GeographicLib::Math::sincosd(latitude, sinLatitude, cosLatitude);
  const double squared = this->Location.Flattening * (2.0 - this->Location.Flattening);
  const double radius =
    this->Location.SemiMajorAxis / std::sqrt(1.0 - squared * sinLatitude * sinLatitude);
  Place place;
  place.Up = { { cosLatitude * cosLongitude, cosLatitude * sinLongitude, sinLatitude } };
  place.Position = { { radius * place.Up[0], radius * place.Up[1],
    (1.0 - squared) * radius * place.Up[2] } };
  return place;
}

std::array<double, 2> GeocentricFrame::GetRadii(double latitude) const
{
  double sine;
  double cosine;
  GeographicLib::Math::sincosd(latitude, sine, cosine);
  const double squared = this->Location.Flattening * (2.0 - this->Location.Flattening);
  const double root = std::sqrt(1.0 - squared * sine * sine);
  const double across = this->Location.SemiMajorAxis / root;
  return { { across, across * (1.0 - squared) / (root * root) } };
}

std::array<double, 3> GeocentricFrame::ToWorld(const std::array<double, 3>& geographic) const
{
  const Place place = this->GetPlace(geographic[0], geographic[1]);
  std::array<double, 3> world;
  for (int i = 0; i < 3; ++i)
  {
    world[i] = place.Position[i] + geographic[2] * place.Up[i];
  }
  return world;
}

std::array<double, 3> GeocentricFrame::ToGeographic(const std::array<double, 3>& world) const
{
  const GeographicLib::Geocentric ellipsoid(
    this->Location.SemiMajorAxis, this->Location.Flattening);
  std::array<double, 3> geographic;
  ellipsoid.Reverse(world[0], world[1], world[2], geographic[1], geographic[0], geographic[2]);
  return geographic;
}
}
