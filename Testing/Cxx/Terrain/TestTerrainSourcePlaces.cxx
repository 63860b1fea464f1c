// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkTerrainSource and vtkGeographicVectors promise errors for georeferences and ellipsoids that
// are not possible.
#include "RelevoCheck.h"
#include "RelevoGeographicMesh.h"
#include "RelevoRasterFiles.h"

#include "vtkExecutive.h"
#include "vtkGeographicVectors.h"
#include "vtkHeightMap.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTerrainSource.h"

#include <cmath>
#include <fstream>
#include <iostream>

namespace
{
RelevoRaster MakeRaster(const std::vector<double>& transform, const std::string& system)
{
  RelevoRaster raster;
  raster.Width = 6;
  raster.Height = 5;
  raster.Type = GDT_Byte;
  raster.SetValues([](int, int column, int row) { return column + row; });
  raster.Transform = transform;
  raster.CoordinateSystem = system;
  return raster;
}

void ExpectError(RelevoCheck& check, const std::string& name, const std::string& reason)
{
  vtkNew<vtkTerrainSource> source;
  RelevoErrors errors(source);
  RelevoErrors executive(source->GetExecutive());
  source->SetFileName(name.c_str());
  CHECK_EQUAL(source->GetExecutive()->Update(), 0);
  if (!CHECK(errors.Said(name + reason)))
  {
    std::cerr << "  for " << name << "\n";
  }
  CHECK_EQUAL(source->GetOutput()->GetNumberOfPoints(), 0);
}

const std::vector<std::vector<double>> HostileTransforms = {
  { 0.0, 1e308, 0.0, 0.0, 0.0, -1e-300 },    // the width is not finite
  { 0.0, 1e300, 0.0, 0.0, 0.0, -1e-290 },    // finite, but beyond the float range
  { 1e305, 1e300, 0.0, -1e305, 0.0, -1e-3 }, //
  { 1e300, 1.0, 0.0, 1e300, 0.0, -1.0 },     // doubles cannot distinguish the corners
  { 10.0, 1e-30, 0.0, 50.0, 0.0, -1e-30 },   //
};

void TestTransforms(RelevoCheck& check, const RelevoTestFolders& folders)
{
  const std::string reason = " has an invalid georeference";
  const std::string beyond = " has latitudes beyond the poles, so its coordinate system";
  const std::string name = folders.File("TerrainPlaces.tif");
  for (const char* system : { "", "EPSG:32633", "EPSG:4326" })
  {
    for (const auto& transform : HostileTransforms)
    {
      // All longitudes are valid.
      const bool isGeographic = system == std::string("EPSG:4326");
      const bool isOnEarth = isGeographic && transform[1] > 1e200;
      const bool isBeyond = isGeographic && transform[3] > 90.0;
      CHECK(MakeRaster(transform, system).Write(name));
      ExpectError(check, name, isOnEarth ? "" : isBeyond ? beyond : reason);
    }
  }
  CHECK(MakeRaster({ 10.0, 0.1, 0.0, 200.0, 0.0, -0.1 }, "EPSG:4326").Write(name));
  ExpectError(check, name, beyond);

  const std::string picture = folders.File("TerrainPlaces.png");
  CHECK(MakeRaster({}, "").Write(picture, "PNG"));
  std::ofstream(folders.File("TerrainPlaces.pgw")) << "1e308\n0\n0\n-1e-300\n0\n0\n";
  ExpectError(check, picture, reason);
}

// Imagery with such a georeference is an error or is stretched over the terrain.
void TestImagery(RelevoCheck& check, const RelevoTestFolders& folders)
{
  const std::string terrain = folders.File("TerrainPlacesGood.tif");
  const std::string picture = folders.File("TerrainPlacesImagery.tif");
  CHECK(MakeRaster({ 10.0, 0.1, 0.0, 50.0, 0.0, -0.1 }, "EPSG:4326").Write(terrain));
  for (const auto& transform : HostileTransforms)
  {
    CHECK(MakeRaster(transform, "EPSG:4326").Write(picture));
    vtkNew<vtkTerrainSource> source;
    RelevoErrors errors(source);
    RelevoErrors executive(source->GetExecutive());
    source->SetFileName(terrain.c_str());
    source->SetImageryFileName(picture.c_str());
    source->SetMaximumImagerySize(16);
    const bool isDrawn = source->GetExecutive()->Update() == 1;
    CHECK(isDrawn || errors.Said("Cannot drape " + picture));
    CHECK_EQUAL((source->GetImagery()->GetNumberOfPoints() > 0), isDrawn);
  }
}

void TestEllipsoids(RelevoCheck& check, const RelevoTestFolders& folders)
{
  for (const char* inverse : { "0.5", "0.9" })
  {
    CHECK_CASE(inverse);
    const std::string system =
      std::string("GEOGCS[\"egg\",DATUM[\"egg\",SPHEROID[\"egg\",6378137,") + inverse +
      "]],PRIMEM[\"Greenwich\",0],UNIT[\"degree\",0.0174532925199433]]";
    const std::string name = folders.File(std::string("TerrainEllipsoid") + inverse + ".tif");
    CHECK(MakeRaster({ 10.0, 0.1, 0.0, 50.0, 0.0, -0.1 }, system).Write(name));
    ExpectError(check, name, " has an ellipsoid that is not supported");

    vtkNew<vtkGeographicVectors> vectors;
    RelevoErrors errors(vectors);
    RelevoErrors executive(vectors->GetExecutive());
    auto mesh = RelevoMakePoints({ { 0.0, 0.0 } });
    mesh->GetPointData()->AddArray(RelevoMakeArray("Wind", { { 1.0, 2.0 } }));
    vectors->SetInputData(mesh);
    vectors->SetCoordinateSystem(system.c_str());
    vectors->Update();
    CHECK(errors.Said("its ellipsoid is not supported"));
  }
}

// Positions in an error refer to the overview that was read, and the error mentions it.
void TestOverview(RelevoCheck& check, const RelevoTestFolders& folders)
{
  RelevoRaster raster = MakeRaster({}, "");
  raster.Width = 256;
  raster.Height = 128;
  raster.Type = GDT_Float32;
  raster.SetValues(
    [](int, int column, int row) { return column / 4 == 20 && row / 2 == 7 ? std::nan("") : 1.0; });
  const std::string name = folders.File("TerrainOverview.tif");
  CHECK(raster.Write(name));
  GDALDatasetH dataset = GDALOpen(name.c_str(), GA_Update);
  int factor = 2;
  CHECK_EQUAL(
    GDALBuildOverviews(dataset, "NEAREST", 1, &factor, 0, nullptr, nullptr, nullptr), CE_None);
  GDALClose(dataset);

  vtkNew<vtkHeightMap> map;
  RelevoErrors errors(map);
  map->SetFileName(name.c_str());
  CHECK(!map->Update());
  CHECK(errors.Said(": 8 of 32768 heights are NaN or infinite, the first in column 80, row 14;"));
  map->SetMaximumDimension(100);
  CHECK(!map->Update());
  CHECK(errors.Said("in its overview of 128 x 64, 2 of 8192 heights are NaN or infinite, the first "
                    "in column 40, row 7;"));
}
}

int TestTerrainSourcePlaces(int argc, char* argv[])
{
  const RelevoTestFolders folders(argc, argv);
  RelevoCheck check;
  TestTransforms(check, folders);
  TestImagery(check, folders);
  TestEllipsoids(check, folders);
  TestOverview(check, folders);
  return check.GetResult();
}
