// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkHeightMapToRelief promises that reliefs of rasters lie where vtkTerrainSource puts them.
#include "Data/Relief.h"
#include "RelevoCheck.h"
#include "RelevoRasterFiles.h"
#include "RelevoReliefs.h"

#include "vtkExecutive.h"
#include "vtkHeightMap.h"
#include "vtkHeightMapToRelief.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTerrainSource.h"

#include <cmath>
#include <iostream>

namespace
{
using relevo::dvec3;
using relevo::dvec4;
using relevo::Relief;

// In metres or feet, north up or rotated, texels equal the samples, bit for bit, at their
// positions.
void TestPlanar(RelevoCheck& check, const RelevoTestFolders& folders)
{
  const std::vector<double> transforms[] = { { 500000.0, 30.0, 0.0, 5200000.0, 0.0, -20.0 },
    { 500000.0, 30.0, 8.0, 5200000.0, 6.0, -20.0 }, { 1000.0, -30.0, 0.0, 2000.0, 0.0, 20.0 } };
  for (const auto& transform : transforms)
  {
    for (const char* unit : { "", "ft" })
    {
      RelevoRaster raster = RelevoRaster::MakeSlope(9, 6, transform, "EPSG:32610", 100.0);
      raster.NoData = 105.0;
      raster.Unit = unit;
      const std::string name = folders.File("ReliefPlanar.tif");
      CHECK(raster.Write(name));
      vtkNew<vtkTerrainSource> source;
      source->SetFileName(name.c_str());
      source->SetExaggeration(2.0);
      source->Update();
      vtkNew<vtkHeightMapToRelief> filter;
      filter->SetHeightMap(source->GetHeightMap());
      filter->SetExaggeration(2.0);
      const Relief relief = RelevoReadRelief(check, filter);
      int voids = 0;
      for (int row = 0; row < 6; ++row)
      {
        for (int column = 0; column < 9; ++column)
        {
          const double height = source->GetHeightMap()->GetSample(column, row);
          const dvec3 point = RelevoGetPoint(relief, column, row);
          if (!(point.z == point.z)) // NaN
          {
            ++voids;
            continue;
          }
          dvec3 place;
          CHECK(source->TerrainToMap(&point.x, &place.x));
          // This is the position in the file.
          const double x = place.x - transform[0];
          const double y = place.y - transform[3];
          const double area = transform[1] * transform[5] - transform[2] * transform[4];
          const double fileColumn = (x * transform[5] - y * transform[2]) / area - 0.5;
          const double fileRow = (y * transform[1] - x * transform[4]) / area - 0.5;
          CHECK_NEAR(place.z, 100.0 + fileColumn + fileRow, 1e-4);
          CHECK_NEAR(place.z, height, 1e-4);
          CHECK(*unit || point.z == 2.0 * height);
        }
      }
      CHECK_EQUAL(voids, 6); // one per row
    }
  }
}

// Heights of the relief equal those of the terrain at the points of the mesh.
void TestGeographic(RelevoCheck& check, const std::string& name, int voids, double worst)
{
  vtkNew<vtkTerrainSource> source;
  source->SetFileName(name.c_str());
  source->Update();
  vtkNew<vtkHeightMapToRelief> filter;
  filter->SetHeightMap(source->GetHeightMap());
  const Relief relief = RelevoReadRelief(check, filter);
  vtkHeightMap* map = source->GetHeightMap();

  // Every texel lies on the terrain.
  double deviation = 0.0;
  vtkIdType outside = 0;
  double corners[2][3];
  for (vtkIdType i : { 0, 1 })
  {
    CHECK_CASE(i);
    const double u = static_cast<double>(i);
    vtkIdType point = 0;
    vtkDataArray* uv = source->GetOutput()->GetPointData()->GetTCoords();
    while (uv->GetComponent(point, 0) != u || uv->GetComponent(point, 1) != u)
    {
      ++point;
    }
    CHECK(source->TerrainToMap(source->GetOutput()->GetPoint(point), corners[i]));
  }
  for (int row = 0; row < relief.GetHeight(); ++row)
  {
    for (int column = 0; column < relief.GetWidth(); ++column)
    {
      const dvec3 point = relief.GetWorldPoint(column, row, 0.0);
      dvec3 place;
      CHECK(source->TerrainToMap(&point.x, &place.x));
      const double u = (place.x - corners[0][0]) / (corners[1][0] - corners[0][0]);
      const double v = (place.y - corners[0][1]) / (corners[1][1] - corners[0][1]);
      const bool isInside = u > 0.0 && u < 1.0 && v > 0.0 && v < 1.0;
      const double z = RelevoGetPoint(relief, column, row).z;
      outside += isInside ? 0 : 1;
      if (z == z) // not NaN
      {
        deviation = std::max(deviation, std::abs(z - map->GetHeight(u, v)));
      }
      CHECK(isInside || z != z);
    }
  }
  CHECK_NEAR(deviation, 0.0, worst);
  const vtkIdType missing = relief.GetNumberOfTexels() - relief.GetNumberOfValidTexels();
  std::cout << name << ": " << outside << " texels outside, " << missing - outside
            << " without data, deviation up to " << deviation << " m\n";
  // The relief is narrower in the north than in the south, by the cosines of the latitudes.
  const double radians = std::acos(-1.0) / 180.0;
  const double share =
    0.5 * (1.0 - std::cos(corners[1][1] * radians) / std::cos(corners[0][1] * radians));
  CHECK_NEAR(static_cast<double>(outside) / relief.GetNumberOfTexels(), share, 0.1 * share + 0.002);
  CHECK_NEAR(static_cast<double>(missing - outside), voids, 0.02 * voids);
}

void TestErrors(RelevoCheck& check, const RelevoTestFolders& folders)
{
  const std::string name = folders.File("ReliefHorizon.tif");
  CHECK(RelevoRaster::MakeSlope(36, 18, { -180.0, 10.0, 0.0, 90.0, 0.0, -10.0 }, "EPSG:4326")
          .Write(name));
  vtkNew<vtkHeightMap> map;
  map->SetFileName(name.c_str());
  vtkNew<vtkHeightMapToRelief> filter;
  filter->SetHeightMap(map);
  RelevoErrors errors(filter);
  RelevoErrors executive(filter->GetExecutive());
  CHECK_EQUAL(filter->GetExecutive()->Update(), 0);
  CHECK(errors.Said(name + " reaches beyond the horizon of its centre"));
  CHECK_EQUAL(filter->GetOutput()->GetNumberOfPoints(), 0);
}
}

int TestHeightMapToReliefTerrain(int argc, char* argv[])
{
  const RelevoTestFolders folders(argc, argv);
  RelevoCheck check;
  TestPlanar(check, folders);
  const std::string name = folders.File("ReliefGeographic.tif");
  CHECK(
    RelevoRaster::MakeSlope(60, 40, { 7.0, 0.05, 0.0, 48.0, 0.0, -0.05 }, "EPSG:4326").Write(name));
  TestGeographic(check, name, 0, 0.01);
  if (!folders.RealData.empty())
  {
    TestGeographic(check, folders.RealData + "mt_rainier_90m.tif", 9033, 0.5);
  }
  TestErrors(check, folders);
  return check.GetResult();
}
