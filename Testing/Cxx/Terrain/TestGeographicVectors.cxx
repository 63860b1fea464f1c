// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkGeographicVectors promises vectors to the east and north in terrain coordinates, for every
// kind of coordinate system.
#include "RelevoCheck.h"
#include "RelevoGeodesy.h"
#include "RelevoGeographicMesh.h"
#include "RelevoRasterFiles.h"

#include "vtkGeographicVectors.h"
#include "vtkPointData.h"
#include "vtkTerrainSource.h"

#include <GeographicLib/UTMUPS.hpp>

#include <algorithm>

namespace
{
using Places = std::vector<std::array<double, 2>>;
constexpr double Radians = 0.017453292519943295;
// Components are stored as floats.
constexpr double Precision = 3e-7;

// The same vector at several points of a terrain with this coordinate system and origin.
std::vector<std::array<double, 3>> Turn(const std::string& system, double originX, double originY,
  const Places& places, const std::vector<double>& vector, double exaggeration = 1.0)
{
  vtkNew<vtkGeographicVectors> filter;
  const auto mesh = RelevoMakePoints(places);
  const std::vector<std::vector<double>> tuples(places.size(), vector);
  mesh->GetPointData()->AddArray(RelevoMakeArray("Wind", tuples));
  filter->SetInputData(mesh);
  filter->SetCoordinateSystem(system.c_str());
  filter->SetOrigin(originX, originY, 0.0);
  filter->SetExaggeration(exaggeration);
  filter->Update();
  std::vector<std::array<double, 3>> result;
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    result.push_back(RelevoVectorOf(filter->GetOutput(), static_cast<vtkIdType>(i), "Wind"));
  }
  return result;
}

double Azimuth(const std::array<double, 3>& vector) // in radians, from y to x
{
  return std::atan2(vector[0], vector[1]);
}

// East and north follow the parallel and the meridian in the local frame.
void TestTangentFrame(RelevoCheck& check)
{
  const double longitude0 = 11.5;
  const double latitude0 = 57.5;
  const double step = 1e-4; // degrees
  double minimumTurn = 1.0;
  for (const double dLongitude : { -20.0, -1.0, 0.0, 3.0, 40.0 })
  {
    for (const double dLatitude : { -30.0, -0.5, 0.0, 5.0, 32.0 })
    {
      const double longitude = longitude0 + dLongitude;
      const double latitude = latitude0 + dLatitude;
      const auto place = [&](double lon, double lat)
      { return RelevoEastNorthUp(lon, lat, longitude0, latitude0); };
      const auto centre = place(longitude, latitude);
      const Places places = { { centre[0], centre[1] } };
      const auto along = [&](const std::array<double, 3>& low, const std::array<double, 3>& high)
      { return std::atan2(high[0] - low[0], high[1] - low[1]); };
      const double east =
        along(place(longitude - step, latitude), place(longitude + step, latitude));
      const double north =
        along(place(longitude, latitude - step), place(longitude, latitude + step));
      const auto turnedEast = Turn("EPSG:4326", longitude0, latitude0, places, { 4.0, 0.0 })[0];
      const auto turnedNorth =
        Turn("EPSG:4326", longitude0, latitude0, places, { 0.0, 3.0, 2.0 })[0];
      CHECK_NEAR(Azimuth(turnedEast), east, 1e-6);
      CHECK_NEAR(Azimuth(turnedNorth), north, 1e-6);
      CHECK_NEAR(std::hypot(turnedEast[0], turnedEast[1]), 4.0, 4.0 * Precision);
      CHECK_NEAR(std::hypot(turnedNorth[0], turnedNorth[1]), 3.0, 3.0 * Precision);
      CHECK(turnedEast[2] == 0.0 && turnedNorth[2] == 2.0);
      // Meridians converge, so far to the east north has another direction.
      if (dLongitude == 40.0)
      {
        minimumTurn = std::min(minimumTurn, std::abs(north));
      }
    }
  }
  CHECK_GREATER(minimumTurn, 0.3);
  // Coordinates are grads from Paris on the Clarke 1880 (IGN) ellipsoid. The vector points
  // north-east, one grad to the east.
  const auto grads = [](double lon, double lat)
  {
    return RelevoEastNorthUp(
      0.9 * lon, 0.9 * lat, 0.0, 0.9 * 52.0, 6378249.2, 1.0 / 293.4660212936269);
  };
  const auto here = grads(1.0, 53.0);
  const auto there = grads(1.0, 53.0001);
  const auto turned = Turn("EPSG:4807", 0.0, 52.0, { { here[0], here[1] } }, { 0.0, 1.0 })[0];
  CHECK_NEAR(Azimuth(turned), std::atan2(there[0] - here[0], there[1] - here[1]), 1e-6);
  // Beyond the horizon, vectors are missing.
  CHECK(std::isnan(Turn("EPSG:4326", 11.5, 57.5, { { 7e6, 0.0 } }, { 1.0, 1.0 })[0][0]));
}

// The references are GeographicLib's convergence and, on the sphere, tan(gamma) = tan(lambda)
// sin(phi).
void TestTransverseMercator(RelevoCheck& check)
{
  for (const double dLongitude : { -3.0, -0.7, 0.0, 1.5, 2.9 })
  {
    for (const double latitude : { -60.0, -5.0, 12.0, 46.85, 78.0 })
    {
      int zone;
      bool isNorth;
      double x;
      double y;
      double gamma;
      double scale;
      GeographicLib::UTMUPS::Forward(
        latitude, 15.0 + dLongitude, zone, isNorth, x, y, gamma, scale, 33);
      const std::string code = "EPSG:" + std::to_string(isNorth ? 32633 : 32733);
      const auto turned =
        Turn(code, 500000.0, 5000000.0, { { x - 500000.0, y - 5000000.0 } }, { 3.0, 4.0, 1.0 })[0];
      CHECK_NEAR(std::hypot(turned[0], turned[1]), 5.0, 5.0 * Precision);
      // The convergence is the azimuth of grid north.
      const double expected = std::atan2(3.0, 4.0) - gamma * Radians;
      CHECK_NEAR(Azimuth(turned), expected, 1e-6);
      const double spherical =
        std::atan(std::tan(dLongitude * Radians) * std::sin(latitude * Radians));
      CHECK_NEAR(Azimuth(turned), std::atan2(3.0, 4.0) - spherical, 1e-6);

      // Coordinates in feet give the same.
      const double foot = 1200.0 / 3937.0;
      const auto inFeet =
        Turn("+proj=utm +zone=33 +datum=WGS84 +units=us-ft" + std::string(isNorth ? "" : " +south"),
          x / foot - 1000.0, y / foot, { { 1000.0 * foot, 0.0 } }, { 3.0, 4.0, 1.0 })[0];
      CHECK_NEAR(Azimuth(inFeet), expected, 1e-6);
      CHECK_NEAR(inFeet[0], turned[0], 5e-6);
    }
  }
}

// In a polar projection, meridians are straight.
void TestPolarStereographic(RelevoCheck& check)
{
  for (const double longitude : { -170.0, -45.0, 20.0, 135.0 })
  {
    for (const double distance : { 30.0, 1e4, 3e6 }) // metres from the pole
    {
      const double angle = (longitude + 45.0) * Radians; // EPSG:3413: 45 W points down
      const Places places = { { distance * std::sin(angle), -distance * std::cos(angle) } };
      const auto north = Turn("EPSG:3413", 0.0, 0.0, places, { 0.0, 1.0 })[0];
      CHECK_NEAR(north[0], -std::sin(angle), 2e-6);
      CHECK_NEAR(north[1], std::cos(angle), 2e-6);
      const auto east = Turn("EPSG:3413", 0.0, 0.0, places, { 1.0, 0.0 })[0];
      CHECK_NEAR(east[0], std::cos(angle), 2e-6);
      CHECK_NEAR(east[1], std::sin(angle), 2e-6);
    }
  }
  const auto pole = Turn("EPSG:3413", 0.0, 0.0, { { 0.0, 0.0 } }, { 0.0, 1.0 })[0];
  CHECK(std::isnan(pole[0]) && std::isnan(pole[1]) && std::isnan(pole[2]));
}

// Where a degree of longitude and one of latitude have the same length on the map, north-east leans
// to the east.
void TestPlateCarree(RelevoCheck& check)
{
  const double a = 6371000.0;
  const double latitude = 60.0 * Radians;
  const Places places = { { 1000.0, a * latitude } };
  const auto turned =
    Turn("+proj=eqc +R=6371000 +units=m", 0.0, 0.0, places, { 1.0, 1.0, 0.5 }, 4.0)[0];
  const double tangent = 1.0 / std::cos(latitude);
  CHECK_NEAR(turned[0] / turned[1], tangent, 1e-5);
  CHECK_NEAR(std::hypot(turned[0], turned[1]), std::sqrt(2.0), 1e-6);
  CHECK_NEAR(turned[2], 2.0, 1e-6);
}

// At the antimeridian, where the grid ends, differences are one-sided.
void TestAntimeridian(RelevoCheck& check)
{
  const double edge = 20037508.342789244; // border of web Mercator in metres
  const Places places = { { -edge, 5e6 }, { -edge + 10.0, 5e6 }, { edge - 10.0, 5e6 },
    { edge, 5e6 } };
  for (const auto& turned : Turn("EPSG:3857", 0.0, 0.0, places, { 2.0, 1.0 }))
  {
    CHECK_NEAR(turned[0], 2.0, 0.005);
    CHECK_NEAR(turned[1], 1.0, 0.01); // web Mercator is not exactly conformal
  }
  // Outside the projection's range, vectors are missing.
  const auto outside =
    Turn("+proj=ortho +R=6371000", 0.0, 0.0, { { 6.4e6, 0.0 }, { 0.0, 0.0 } }, { 2.0, 1.0 });
  CHECK(std::isnan(outside[0][0]) && std::abs(outside[1][0] - 2.0) < 1e-5);
}

void TestUnknownSystem(RelevoCheck& check)
{
  for (const std::string& system : { std::string(), std::string("LOCAL_CS[\"plan\"]") })
  {
    CHECK_CASE(system);
    const auto turned = Turn(system, 1.0, 2.0, { { 5.0, 6.0 } }, { 3.0, -4.0, 2.0 }, 1.5)[0];
    CHECK(turned[0] == 3.0 && turned[1] == -4.0 && turned[2] == 3.0);
  }
}

// Uses the terrain's coordinate system, origin and exaggeration.
void TestTerrain(RelevoCheck& check, const RelevoTestFolders& folders)
{
  RelevoRaster raster;
  raster.Width = 40;
  raster.Height = 30;
  raster.Type = GDT_Int16;
  raster.Transform = { 650000.0, 500.0, 0.0, 5600000.0, 0.0, -500.0 };
  raster.CoordinateSystem = "EPSG:32633";
  raster.SetValues([](int, int column, int row) { return column + row; });
  const std::string name = folders.File("GeographicVectors.tif");
  CHECK(raster.Write(name));
  vtkNew<vtkTerrainSource> terrain;
  terrain->SetFileName(name.c_str());
  terrain->SetResolution(4);
  terrain->Update();
  vtkNew<vtkPolyData> mesh;
  mesh->ShallowCopy(terrain->GetOutput());
  const vtkIdType count = mesh->GetNumberOfPoints();
  mesh->GetPointData()->AddArray(RelevoMakeArray(
    "Wind", std::vector<std::vector<double>>(static_cast<std::size_t>(count), { 0.0, 5.0, 1.0 })));

  vtkNew<vtkGeographicVectors> filter;
  filter->SetInputData(mesh);
  filter->SetTerrain(terrain);
  filter->SetOutputArrayName("Turned");
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  CHECK_EQUAL(output->GetNumberOfPoints(), count);
  CHECK_EQUAL(output->GetNumberOfCells(), mesh->GetNumberOfCells());
  CHECK_EQUAL(output->GetPointData()->GetVectors(), output->GetPointData()->GetArray("Turned"));
  CHECK_EQUAL(output->GetPointData()->GetArray("Wind"), mesh->GetPointData()->GetArray("Wind"));
  double widest = 0.0;
  for (vtkIdType i = 0; i < count; ++i)
  {
    double latitude;
    double longitude;
    double gamma;
    double scale;
    GeographicLib::UTMUPS::Reverse(33, true, 660000.0 + mesh->GetPoint(i)[0],
      5592500.0 + mesh->GetPoint(i)[1], latitude, longitude, gamma, scale);
    const auto turned = RelevoVectorOf(output, i, "Turned");
    CHECK_NEAR(Azimuth(turned), -gamma * Radians, 1e-6);
    CHECK_EQUAL(turned[2], 1.0);
    widest = std::max(widest, gamma);
  }
  CHECK_GREATER(widest, 1.5);
  terrain->SetExaggeration(3.0);
  filter->Update();
  CHECK_EQUAL(RelevoVectorOf(filter->GetOutput(), 0, "Turned")[2], 3.0);

  // The mesh's field data contain its location.
  const auto known = RelevoVectorOf(filter->GetOutput(), 0, "Turned");
  filter->SetTerrain(nullptr);
  filter->SetExaggeration(3.0);
  filter->Update();
  CHECK_EQUAL(RelevoVectorOf(filter->GetOutput(), 0, "Turned"), known);
}

// Many points, in several blocks and threads, give the same as single points.
void TestManyPoints(RelevoCheck& check)
{
  Places places;
  for (int i = 0; i < 70000; ++i)
  {
    places.push_back({ 10.0 * (i % 1000) - 5000.0, 1000.0 * std::floor(i / 1000.0) });
  }
  const auto all = Turn("EPSG:32633", 600000.0, 5000000.0, places, { 1.0, 0.0 });
  for (const std::size_t i : { 0, 1023, 1024, 65535, 65536, 69999 })
  {
    CHECK_CASE(i);
    const auto one = Turn("EPSG:32633", 600000.0, 5000000.0, { places[i] }, { 1.0, 0.0 })[0];
    CHECK_EQUAL(one, all[i]);
  }
}
}

int TestGeographicVectors(int argc, char* argv[])
{
  const RelevoTestFolders folders(argc, argv);
  RelevoCheck check;
  TestTangentFrame(check);
  TestTransverseMercator(check);
  TestPolarStereographic(check);
  TestPlateCarree(check);
  TestAntimeridian(check);
  TestUnknownSystem(check);
  TestTerrain(check, folders);
  TestManyPoints(check);
  return check.GetResult();
}
