// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves terrain.md: TerrainToMap() and MapToTerrain() agree with PROJ. Longitude and latitude use
// the ellipsoid's orthographic projection.
#include "RelevoCheck.h"
#include "RelevoRasterFiles.h"

#include "vtkCallbackCommand.h"
#include "vtkExecutive.h"
#include "vtkFloatArray.h"
#include "vtkHeightMap.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTerrainSource.h"
#include "vtkVersionMacros.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace
{
// Converts between two coordinate systems by PROJ, longitude and easting first.
class Transformation
{
public:
  Transformation(const std::string& from, const std::string& to)
  {
    OGRSpatialReferenceH systems[2];
    const std::string* definitions[2] = { &from, &to };
    for (int i = 0; i < 2; ++i)
    {
      systems[i] = OSRNewSpatialReference(nullptr);
      OSRSetFromUserInput(systems[i], definitions[i]->c_str());
      OSRSetAxisMappingStrategy(systems[i], OAMS_TRADITIONAL_GIS_ORDER);
    }
    this->Handle = OCTNewCoordinateTransformation(systems[0], systems[1]);
    OSRDestroySpatialReference(systems[0]);
    OSRDestroySpatialReference(systems[1]);
  }
  ~Transformation() { OCTDestroyCoordinateTransformation(this->Handle); }
  Transformation(const Transformation&) = delete;
  void operator=(const Transformation&) = delete;

  bool operator()(double xy[2]) const
  {
    return this->Handle && OCTTransform(this->Handle, 1, &xy[0], &xy[1], nullptr);
  }

private:
  OGRCoordinateTransformationH Handle;
};

RelevoRaster MakeRaster(const std::vector<double>& transform, const std::string& coordinateSystem)
{
  RelevoRaster raster;
  raster.Width = 40;
  raster.Height = 20;
  raster.Transform = transform;
  raster.CoordinateSystem = coordinateSystem;
  raster.SetValues([](int, int column, int row) { return 100.0 + column + row; });
  return raster;
}

void Open(vtkTerrainSource* source, const RelevoRaster& raster, const std::string& name)
{
  raster.Write(name);
  source->SetFileName(name.c_str());
  source->Update();
}

// Converts there and back, in an area that is within the horizon even for a continent.
void CheckThereAndBack(RelevoCheck& check, vtkTerrainSource* source, double tolerance)
{
  double bounds[6];
  source->GetOutput()->GetBounds(bounds);
  std::transform(bounds, bounds + 4, bounds, [](double bound) { return 0.6 * bound; });
  for (int i = 0; i <= 6; ++i)
  {
    for (int j = 0; j <= 6; ++j)
    {
      const double terrain[3] = { bounds[0] + i / 6.0 * (bounds[1] - bounds[0]),
        bounds[2] + j / 6.0 * (bounds[3] - bounds[2]), 12.5 * i };
      double map[3];
      double again[3];
      CHECK(source->TerrainToMap(terrain, map) && source->MapToTerrain(map, again));
      for (int k = 0; k < 3; ++k)
      {
        CHECK_NEAR(again[k], terrain[k], tolerance);
      }
    }
  }
}

void TestDegrees(RelevoCheck& check, const RelevoTestFolders& folders)
{
  // The rasters cover a country, a continent, and the other side of the date line in longitudes
  // from 0 to 360.
  for (const auto& transform :
    std::vector<std::vector<double>>{ { 10.0, 0.01, 0.0, 46.0, 0.0, -0.01 },
      { -60.0, 3.0, 0.0, 60.0, 0.0, -3.0 }, { 170.0, 1.0, 0.0, -30.0, 0.0, -0.5 } })
  {
    vtkNew<vtkTerrainSource> source;
    source->SetExaggeration(2.0);
    Open(source, MakeRaster(transform, "EPSG:4326"), folders.File("CoordinatesDegrees.tif"));
    CHECK(source->IsGeographic());
    const Transformation project("EPSG:4326",
      "+proj=ortho +ellps=WGS84 +lat_0=" + std::to_string(source->GetOrigin()[1]) +
        " +lon_0=" + std::to_string(source->GetOrigin()[0]));
    double worst = 0.0;
    for (double u : { 0.0, 0.2, 0.5, 0.77, 1.0 })
    {
      CHECK_CASE(u);
      for (double v : { 0.0, 0.3, 0.5, 1.0 })
      {
        CHECK_CASE(v);
        const double map[3] = { transform[0] + 40 * transform[1] * u,
          transform[3] + 20 * transform[5] * v, 250.0 };
        double expected[2] = { map[0], map[1] };
        double terrain[3];
        CHECK(project(expected) && source->MapToTerrain(map, terrain));
        worst = std::max(worst, std::hypot(terrain[0] - expected[0], terrain[1] - expected[1]));
        CHECK_EQUAL(terrain[2], 500.0);
        double again[3];
        CHECK(source->TerrainToMap(terrain, again));
        CHECK_NEAR(again[0], map[0], 1e-10);
        CHECK_NEAR(again[1], map[1], 1e-10);
        CHECK_EQUAL(again[2], 250.0);
      }
    }
    CHECK_NEAR(worst, 0.0, 1e-4); // metres; PROJ gets the origin with six decimals
    CheckThereAndBack(check, source, 1e-5);

    double untouched[3] = { 7.0, 8.0, 9.0 };
    const double outside[3] = { 6.37e6, 6.37e6, 0.0 };
    const double horizon[3] = { 6.36e6, 0.0, 0.0 };
    const double nothing[3] = { std::nan(""), 0.0, 0.0 };
    for (const double* place : { outside, horizon, nothing })
    {
      CHECK(!source->TerrainToMap(place, untouched));
      CHECK(untouched[0] == 7.0 && untouched[1] == 8.0 && untouched[2] == 9.0);
    }
    const double otherSide[3] = { source->GetOrigin()[0] + 180.0, 0.0, 0.0 };
    CHECK(!source->MapToTerrain(otherSide, untouched) && untouched[0] == 7.0);
  }
}

void TestOtherUnits(RelevoCheck& check, const RelevoTestFolders& folders)
{
  vtkNew<vtkTerrainSource> source;
  double map[3];
  const double place[3] = { 300.0, -30.0, 30.48 };
  CHECK(!source->TerrainToMap(place, map) && !source->MapToTerrain(place, map));
  CHECK(!source->IsGeographic());

  // Coordinates are grads on another ellipsoid.
  Open(source, MakeRaster({ 2.0, 0.01, 0.0, 52.0, 0.0, -0.01 }, "EPSG:4807"),
    folders.File("CoordinatesGrads.tif"));
  CHECK(source->IsGeographic());
  CheckThereAndBack(check, source, 1e-6);
  const double corner[3] = { 2.4, 52.0, 0.0 };
  double terrain[3];
  CHECK(source->MapToTerrain(corner, terrain));
  // The northern edge is shorter.
  CHECK_NEAR(terrain[0], source->GetOutput()->GetBounds()[1], 100.0);
  CHECK_NEAR(terrain[1], source->GetOutput()->GetBounds()[3], 1.0);

  // Coordinates and heights are in feet.
  RelevoRaster feet = MakeRaster({ 900000.0, 100.0, 0.0, 200000.0, 0.0, -100.0 }, "EPSG:2263");
  feet.Unit = "ft";
  Open(source, feet, folders.File("CoordinatesFeet.tif"));
  CHECK(!source->IsGeographic() && source->TerrainToMap(place, map));
  CHECK_NEAR(map[0], 902000.0 + 300.0 * 3937.0 / 1200.0, 1e-6);
  CHECK_NEAR(map[1], 199000.0 - 30.0 * 3937.0 / 1200.0, 1e-6);
  CHECK_NEAR(map[2], 100.0, 1e-9);
  CheckThereAndBack(check, source, 1e-8);

  // Without georeference, coordinates are texels.
  Open(source, MakeRaster({}, ""), folders.File("CoordinatesNone.tif"));
  CHECK(source->TerrainToMap(place, map));
  CHECK(map[0] == 320.0 && map[1] == -20.0 && map[2] == 30.48);

  // An image in memory, which has no georeference either.
  vtkNew<vtkImageData> image;
  image->SetDimensions(4, 6, 1);
  image->AllocateScalars(VTK_FLOAT, 1);
  image->GetPointData()->GetScalars()->Fill(5.0);
  source->GetHeightMap()->SetImageData(image);
  source->SetExaggeration(0.0);
  source->Update();
  CHECK(source->TerrainToMap(place, map));
  CHECK(map[0] == 302.0 && map[1] == -27.0 && map[2] == 0.0);

  // No result of an earlier file remains.
  RelevoErrors errors(source);
  RelevoErrors executive(source->GetExecutive());
  source->GetHeightMap()->SetImageData(nullptr);
  source->SetFileName("nowhere.tif");
  source->Update();
  CHECK(errors.Said("nowhere.tif") && !source->TerrainToMap(place, map));
}

// Progress rises, names the current step and stops when aborted.
void TestProgress(RelevoCheck& check, const RelevoTestFolders& folders)
{
  struct Record
  {
    std::vector<double> Shares;
    std::set<std::string> Texts;
    double Stop = 2.0;
  };
  const std::string terrain = folders.File("CoordinatesProgress.tif");
  RelevoRaster raster;
  raster.Width = 3000;
  raster.Height = 1000;
  raster.Type = GDT_Int16;
  raster.SetValues([](int, int column, int row) { return (column + row) % 500; });
  CHECK(raster.Write(terrain));

  vtkNew<vtkTerrainSource> source;
  RelevoErrors errors(source);
  Record record;
  vtkNew<vtkCallbackCommand> observer;
  observer->SetClientData(&record);
  observer->SetCallback(
    [](vtkObject* caller, unsigned long, void* client, void* share)
    {
      auto* algorithm = static_cast<vtkAlgorithm*>(caller);
      auto* written = static_cast<Record*>(client);
      written->Shares.push_back(*static_cast<double*>(share));
      written->Texts.insert(algorithm->GetProgressText() ? algorithm->GetProgressText() : "");
      if (written->Shares.back() > written->Stop)
      {
        algorithm->AbortExecuteOn();
      }
    });
  source->AddObserver(vtkCommand::ProgressEvent, observer);
  source->SetFileName(terrain.c_str());
  source->SetImageryFileName(terrain.c_str());
  source->Update();
  CHECK(errors.None() && source->GetImagery()->GetNumberOfPoints() == 3000 * 1000);
  CHECK(record.Shares.size() >= 6 && record.Shares.back() == 1.0);
  CHECK(std::is_sorted(record.Shares.begin(), record.Shares.end()));
  CHECK(record.Texts.count("reading heights") && record.Texts.count("draping imagery"));

  for (double stop : { 0.1, 0.65, 0.75 })
  {
    record.Shares.clear();
    record.Stop = stop;
    source->Modified();
    source->GetHeightMap()->Modified();
    source->SetAbortExecute(0);
    source->Update();
    CHECK(errors.None() && source->GetOutput()->GetNumberOfPoints() == 0);
    CHECK_EQUAL(source->GetImagery()->GetNumberOfPoints(), 0);
    if (VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 0) && record.Shares.back() == 1.0)
    {
      record.Shares.pop_back(); // VTK's pipeline reports 1 at the end, aborted or not
    }
    CHECK(record.Shares.back() > stop && record.Shares.back() < 1.0);
  }
}
}

int TestTerrainSourceCoordinates(int argc, char* argv[])
{
  const RelevoTestFolders folders(argc, argv);
  RelevoCheck check;
  TestDegrees(check, folders);
  TestOtherUnits(check, folders);
  TestProgress(check, folders);
  return check.GetResult();
}
