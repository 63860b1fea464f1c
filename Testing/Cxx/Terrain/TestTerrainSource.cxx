// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkTerrainSource promises where the mesh lies, how it is triangulated, and where it has holes.
#include "RelevoCheck.h"
#include "RelevoGeodesy.h"
#include "RelevoRasterFiles.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkDisplacement.h"
#include "vtkHeightMap.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTerrainSource.h"

#include <GeographicLib/Geodesic.hpp>

#include <array>
#include <iostream>
#include <map>
#include <set>

namespace
{
double Coordinate(vtkPolyData* mesh, vtkIdType point, int axis)
{
  return mesh->GetPoint(point)[axis];
}

double Texture(vtkPolyData* mesh, vtkIdType point, int component)
{
  return mesh->GetPointData()->GetTCoords()->GetComponent(point, component);
}

vtkIdType FindPoint(vtkPolyData* mesh, double u, double v)
{
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    if (std::abs(Texture(mesh, i, 0) - u) < 1e-6 && std::abs(Texture(mesh, i, 1) - v) < 1e-6)
    {
      return i;
    }
  }
  return -1;
}

// Checks every mesh: triangles face up, each inner edge is used once in each direction, all points
// are used and lie at z = 0, and normals point up. Returns the total area.
double CheckMesh(RelevoCheck& check, vtkPolyData* mesh)
{
  CHECK_EQUAL(mesh->GetNumberOfPolys(), mesh->GetNumberOfCells());
  CHECK_GREATER(mesh->GetNumberOfCells(), 0);
  CHECK(mesh->GetPointData()->GetTCoords() &&
    mesh->GetPointData()->GetTCoords()->GetNumberOfComponents() == 2);
  vtkDataArray* normals = mesh->GetPointData()->GetNormals();
  CHECK(normals && std::string(normals->GetName()) == "Normals");
  for (vtkIdType i = 0; normals && i < mesh->GetNumberOfPoints(); ++i)
  {
    const double* normal = normals->GetTuple3(i);
    CHECK(normal[0] == 0.0 && normal[1] == 0.0 && normal[2] == 1.0);
    CHECK_EQUAL(Coordinate(mesh, i, 2), 0.0);
  }
  std::set<vtkIdType> used;
  std::map<std::pair<vtkIdType, vtkIdType>, int> edges;
  double area = 0.0;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    mesh->GetCellPoints(cell, ids);
    CHECK_EQUAL(ids->GetNumberOfIds(), 3);
    double x[3];
    double y[3];
    for (int i = 0; i < 3; ++i)
    {
      used.insert(ids->GetId(i));
      ++edges[{ ids->GetId(i), ids->GetId((i + 1) % 3) }];
      x[i] = Coordinate(mesh, ids->GetId(i), 0);
      y[i] = Coordinate(mesh, ids->GetId(i), 1);
    }
    const double twice = (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]);
    CHECK_GREATER(twice, 0.0);
    area += 0.5 * twice;
  }
  CHECK_EQUAL(static_cast<vtkIdType>(used.size()), mesh->GetNumberOfPoints());
  for (const auto& edge : edges)
  {
    CHECK_EQUAL(edge.second, 1);
  }
  return area;
}

RelevoRaster MakeRaster(
  int width, int height, const std::vector<double>& transform, const std::string& coordinateSystem)
{
  return RelevoRaster::MakeSlope(width, height, transform, coordinateSystem, 100.0);
}

// A source of this raster, written to a file, with this many squares along the longer side.
vtkSmartPointer<vtkTerrainSource> MakeSource(
  RelevoCheck& check, const RelevoRaster& raster, const std::string& name, int resolution)
{
  CHECK(raster.Write(name));
  auto source = vtkSmartPointer<vtkTerrainSource>::New();
  source->SetFileName(name.c_str());
  source->SetResolution(resolution);
  source->Update();
  return source;
}

void TestGeographic(RelevoCheck& check, const RelevoTestFolders& folders)
{
  const RelevoRaster raster =
    MakeRaster(80, 50, { 10.0, 0.01, 0.0, 46.0, 0.0, -0.01 }, "EPSG:4326");
  const auto source = MakeSource(check, raster, folders.File("TerrainGeographic.tif"), 16);
  vtkPolyData* mesh = source->GetOutput();
  CheckMesh(check, mesh);
  const double longitude0 = 10.4;
  const double latitude0 = 45.75;
  CHECK_NEAR(source->GetOrigin()[0], longitude0, 1e-12);
  CHECK_NEAR(source->GetOrigin()[1], latitude0, 1e-12);
  CHECK_EQUAL(source->GetOrigin()[2], 0.0);
  CHECK_NOT_EQUAL(std::string(source->GetCoordinateSystem()).find("WGS 84"), std::string::npos);
  double worst = 0.0;
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    const auto expected = RelevoEastNorthUp(
      10.0 + 0.8 * Texture(mesh, i, 0), 45.5 + 0.5 * Texture(mesh, i, 1), longitude0, latitude0);
    worst = std::max({ worst, std::abs(Coordinate(mesh, i, 0) - expected[0]),
      std::abs(Coordinate(mesh, i, 1) - expected[1]) });
  }
  CHECK_NEAR(worst, 0.0, 0.01); // metres; texture coordinates and points are floats
  // Here 0.8 degrees are 62 km and 0.5 degrees 56 km: 16 squares along the longer side, and 14 or
  // 15 across.
  CHECK_EQUAL(mesh->GetNumberOfCells(), 2 * 16 * 14);

  // The western edge, point by point, has the length of the geodesic.
  double geodesic = 0.0;
  GeographicLib::Geodesic::WGS84().Inverse(45.5, 10.0, 46.0, 10.0, geodesic);
  const vtkIdType south = FindPoint(mesh, 0.0, 0.0);
  const vtkIdType north = FindPoint(mesh, 0.0, 1.0);
  CHECK_GREATER_EQUAL(south, 0);
  CHECK_GREATER_EQUAL(north, 0);
  const double chord = std::hypot(Coordinate(mesh, north, 0) - Coordinate(mesh, south, 0),
    Coordinate(mesh, north, 1) - Coordinate(mesh, south, 1));
  CHECK_NEAR(chord / geodesic, 1.0, 1e-4);
}

// Another ellipsoid, with longitude and latitude in grads.
void TestEllipsoid(RelevoCheck& check, const RelevoTestFolders& folders)
{
  const RelevoRaster raster =
    MakeRaster(40, 40, { 2.0, 0.01, 0.0, 52.0, 0.0, -0.01 }, "EPSG:4807"); // NTF (Paris), grads
  const auto source = MakeSource(check, raster, folders.File("TerrainGrads.tif"), 8);
  vtkPolyData* mesh = source->GetOutput();
  const vtkIdType corner = FindPoint(mesh, 1.0, 1.0);
  CHECK_GREATER_EQUAL(corner, 0);
  const auto expected = RelevoEastNorthUp(
    2.4 * 0.9, 52.0 * 0.9, 2.2 * 0.9, 51.8 * 0.9, 6378249.2, 1.0 / 293.4660212936269);
  CHECK_NEAR(Coordinate(mesh, corner, 0), expected[0], 0.01);
  CHECK_NEAR(Coordinate(mesh, corner, 1), expected[1], 0.01);
}

void TestProjected(RelevoCheck& check, const RelevoTestFolders& folders)
{
  const RelevoRaster raster =
    MakeRaster(100, 60, { 500010.0, 30.0, 0.0, 5100020.0, 0.0, -20.0 }, "EPSG:32633");
  const auto source = MakeSource(check, raster, folders.File("TerrainProjected.tif"), 10);
  vtkPolyData* mesh = source->GetOutput();
  CHECK_NEAR(CheckMesh(check, mesh), 3000.0 * 1200.0, 1.0);
  CHECK_EQUAL(mesh->GetNumberOfCells(), 2 * 10 * 4);
  double bounds[6];
  mesh->GetBounds(bounds);
  CHECK(bounds[0] == -1500.0 && bounds[1] == 1500.0 && bounds[2] == -600.0 && bounds[3] == 600.0);
  CHECK(source->GetOrigin()[0] == 501510.0 && source->GetOrigin()[1] == 5099420.0);
  OGRSpatialReferenceH system = OSRNewSpatialReference(source->GetCoordinateSystem());
  CHECK(system && OSRGetAuthorityCode(system, nullptr) &&
    std::string(OSRGetAuthorityCode(system, nullptr)) == "32633");
  OSRDestroySpatialReference(system);

  // The mesh is never finer than the texels. A resolution without squares is an error.
  source->SetResolution(100000);
  source->Update();
  CHECK_EQUAL(source->GetOutput()->GetNumberOfCells(), 2 * 100 * 60);
  RelevoErrors errors(source);
  source->SetResolution(0);
  CHECK(errors.Said("Resolution"));
  CHECK_EQUAL(source->GetResolution(), 100000);
  source->SetResolution(1);
  source->Update();
  CHECK_EQUAL(source->GetOutput()->GetNumberOfCells(), 2);
  CheckMesh(check, source->GetOutput());
}

// Feet are converted to metres, for coordinates and heights.
void TestFeet(RelevoCheck& check, const RelevoTestFolders& folders)
{
  RelevoRaster raster =
    MakeRaster(20, 10, { 900000.0, 100.0, 0.0, 200000.0, 0.0, -100.0 }, "EPSG:2263");
  raster.Unit = "ft";
  const std::string name = folders.File("TerrainFeet.tif");
  CHECK(raster.Write(name));
  vtkNew<vtkTerrainSource> source;
  source->SetFileName(name.c_str());
  source->SetExaggeration(3.0);
  CHECK_EQUAL(source->GetDisplacement()->GetScale(), 3.0);
  source->Update();
  double bounds[6];
  source->GetOutput()->GetBounds(bounds);
  const double foot = 1200.0 / 3937.0;
  CHECK_NEAR(bounds[1] - bounds[0], 2000.0 * foot, 1e-3);
  CHECK_NEAR(bounds[3] - bounds[2], 1000.0 * foot, 1e-3);
  CHECK_NEAR(source->GetDisplacement()->GetScale(), 3.0 * 0.3048, 1e-12);
  CHECK_NEAR(source->GetOrigin()[0], 901000.0, 1e-6); // in the raster's coordinates
  source->SetExaggeration(2.0);
  CHECK_NEAR(source->GetDisplacement()->GetScale(), 2.0 * 0.3048, 1e-12);
}

void TestWithoutGeoreference(RelevoCheck& check, const RelevoTestFolders& folders)
{
  RelevoRaster raster = MakeRaster(30, 20, {}, "");
  raster.Type = GDT_UInt16;
  const std::string name = folders.File("TerrainPlain.png");
  CHECK(raster.Write(name, "PNG"));
  vtkNew<vtkTerrainSource> source;
  source->SetFileName(name.c_str());
  source->Update();
  CHECK_NEAR(CheckMesh(check, source->GetOutput()), 600.0, 1e-3);
  double bounds[6];
  source->GetOutput()->GetBounds(bounds);
  CHECK(bounds[0] == -15.0 && bounds[1] == 15.0 && bounds[2] == -10.0 && bounds[3] == 10.0);
  CHECK(source->GetOrigin()[0] == 15.0 && source->GetOrigin()[1] == 10.0);
  CHECK(std::string(source->GetCoordinateSystem()).empty());
  CHECK_EQUAL(source->GetImagery(), nullptr);

  // The same image in memory gives the same terrain.
  vtkNew<vtkImageData> image;
  image->SetDimensions(30, 20, 1);
  image->AllocateScalars(VTK_FLOAT, 1);
  image->GetPointData()->GetScalars()->Fill(5.0);
  vtkNew<vtkTerrainSource> fromImage;
  fromImage->GetHeightMap()->SetImageData(image);
  fromImage->Update();
  CHECK_EQUAL(fromImage->GetOutput()->GetNumberOfCells(), source->GetOutput()->GetNumberOfCells());
  CHECK_EQUAL(fromImage->GetOutput()->GetLength(), source->GetOutput()->GetLength());
}

// Files with rows to the south, to the west or rotated by 90 degrees cover the same area and face
// up.
void TestOrientations(RelevoCheck& check, const RelevoTestFolders& folders)
{
  const std::vector<std::vector<double>> transforms = {
    { 1000.0, 10.0, 0.0, 2000.0, 0.0, -10.0 }, // north-up
    { 1000.0, 10.0, 0.0, 1500.0, 0.0, 10.0 },
    { 1800.0, -10.0, 0.0, 2000.0, 0.0, -10.0 },
    { 1800.0, -10.0, 0.0, 1500.0, 0.0, 10.0 },
  };
  for (const auto& transform : transforms)
  {
    RelevoRaster raster = MakeRaster(80, 50, transform, "EPSG:32633");
    raster.SetValues(
      [&](int, int column, int row)
      {
        const double x = transform[0] + transform[1] * (column + 0.5);
        const double y = transform[3] + transform[5] * (row + 0.5);
        return x + 2.0 * y;
      });
    const auto source = MakeSource(check, raster, folders.File("TerrainOrientation.tif"), 16);
    vtkPolyData* mesh = source->GetOutput();
    CHECK_NEAR(CheckMesh(check, mesh), 800.0 * 500.0, 1.0);
    const vtkIdType southWest = FindPoint(mesh, 0.0, 0.0);
    CHECK_GREATER_EQUAL(southWest, 0);
    CHECK_EQUAL(Coordinate(mesh, southWest, 0), -400.0);
    CHECK_EQUAL(Coordinate(mesh, southWest, 1), -250.0);
    CHECK_NEAR(source->GetHeightMap()->GetHeight(0.5, 0.5), 1400.0 + 2.0 * 1750.0, 0.1);
    CHECK_NEAR(source->GetHeightMap()->GetHeight(0.8, 0.2), 1640.0 + 2.0 * 1600.0, 0.1);
  }

  // Columns run to the north-east and rows to the south-east.
  RelevoRaster turned = MakeRaster(40, 20, { 1000.0, 6.0, 6.0, 2000.0, 6.0, -6.0 }, "EPSG:32633");
  turned.SetValues([](int, int column, int row) { return column - 3 * row; });
  const auto source = MakeSource(check, turned, folders.File("TerrainTurned.tif"), 8);
  vtkPolyData* mesh = source->GetOutput();
  CHECK_NEAR(CheckMesh(check, mesh), 800.0 * 72.0, 1.0);
  // The file's first corner has u = 0 and v = 1.
  const vtkIdType first = FindPoint(mesh, 0.0, 1.0);
  CHECK_GREATER_EQUAL(first, 0);
  CHECK_NEAR(Coordinate(mesh, first, 0), 1000.0 - (1000.0 + 6.0 * 20 + 6.0 * 10), 1e-3);
  CHECK_NEAR(Coordinate(mesh, first, 1), 2000.0 - (2000.0 + 6.0 * 20 - 6.0 * 10), 1e-3);
  CHECK_NEAR(source->GetHeightMap()->GetHeight(0.5 / 40, 1.0 - 0.5 / 20), 0.0, 0.01);
}

void TestNoData(RelevoCheck& check, const RelevoTestFolders& folders)
{
  RelevoRaster raster = MakeRaster(64, 64, { 0.0, 10.0, 0.0, 640.0, 0.0, -10.0 }, "EPSG:32633");
  raster.NoData = -9999.0;
  raster.SetValues(
    [](int, int column, int row) {
      return std::hypot(column - 31.5, row - 40.0) < 14.3 || column > 60 ? -9999.0 : 50.0 + column;
    });
  const std::string name = folders.File("TerrainNoData.tif");
  CHECK(raster.Write(name));
  vtkNew<vtkTerrainSource> source;
  source->SetFileName(name.c_str());
  source->SetResolution(32);
  CHECK_EQUAL(source->GetNoDataPolicy(), vtkDisplacement::HOLE);
  source->Update();
  vtkNew<vtkPolyData> holes;
  holes->DeepCopy(source->GetOutput());
  const double area = CheckMesh(check, holes);
  CHECK_EQUAL(source->GetDisplacement()->GetNoDataPolicy(), vtkDisplacement::HOLE);
  source->SetNoDataPolicyToFill();
  source->Update();
  vtkPolyData* full = source->GetOutput();
  CHECK_NEAR(CheckMesh(check, full), 640.0 * 640.0, 1.0);
  CHECK_EQUAL(full->GetNumberOfCells(), 2 * 32 * 32);
  CHECK_EQUAL(source->GetDisplacement()->GetNoDataPolicy(), vtkDisplacement::FILL);
  CHECK_LESS(area, 0.9 * 640.0 * 640.0);

  // Squares are left out exactly if they depend on missing samples only.
  std::set<std::pair<int, int>> kept;
  const auto squareOf = [](vtkPolyData* mesh, vtkIdType cell)
  {
    double u = 0.0;
    double v = 0.0;
    vtkNew<vtkIdList> ids;
    mesh->GetCellPoints(cell, ids);
    for (int i = 0; i < 3; ++i)
    {
      u += Texture(mesh, ids->GetId(i), 0) / 3.0;
      v += Texture(mesh, ids->GetId(i), 1) / 3.0;
    }
    return std::pair<int, int>(static_cast<int>(u * 32), static_cast<int>(v * 32));
  };
  for (vtkIdType cell = 0; cell < holes->GetNumberOfCells(); ++cell)
  {
    kept.insert(squareOf(holes, cell));
  }
  CHECK_EQUAL(holes->GetNumberOfCells(), static_cast<vtkIdType>(2 * kept.size()));
  const auto isVoid = [&](int column, int v)
  {
    const int row = 63 - v;
    return column < 0 || column > 63 || row < 0 || row > 63 || raster.At(0, column, row) == -9999.0;
  };
  for (int j = 0; j < 32; ++j)
  {
    for (int i = 0; i < 32; ++i)
    {
      // A square of two texels depends on these and on one more on each side.
      bool onlyVoids = true;
      for (int v = 2 * j - 1; v <= 2 * j + 2; ++v)
      {
        for (int u = 2 * i - 1; u <= 2 * i + 2; ++u)
        {
          onlyVoids = onlyVoids && isVoid(u, v);
        }
      }
      CHECK_NOT_EQUAL(onlyVoids, (kept.count({ i, j }) > 0));
    }
  }
}

// A strip of one texel's width and a single texel are surfaces of that size.
void TestThin(RelevoCheck& check, const RelevoTestFolders& folders)
{
  for (const auto& size : { std::pair<int, int>{ 1, 1 }, { 1, 12 }, { 12, 1 } })
  {
    const RelevoRaster raster =
      MakeRaster(size.first, size.second, { 0.0, 10.0, 0.0, 100.0, 0.0, -10.0 }, "EPSG:32633");
    const std::string name = folders.File("TerrainThin.tif");
    CHECK(raster.Write(name));
    vtkNew<vtkTerrainSource> source;
    source->SetFileName(name.c_str());
    source->Update();
    CHECK_NEAR(CheckMesh(check, source->GetOutput()), 100.0 * size.first * size.second, 1e-3);
    CHECK_EQUAL(source->GetOutput()->GetNumberOfCells(), 2 * size.first * size.second);
  }
}

void TestRecipe(RelevoCheck& check, const RelevoTestFolders& folders)
{
  vtkNew<vtkTerrainSource> source;
  vtkDisplacement* displacement = source->GetDisplacement();
  CHECK(displacement && displacement->GetHeightMap() == source->GetHeightMap());
  CHECK(!displacement->IsAlongNormal());
  CHECK(displacement->GetDirection()[2] == 1.0 && displacement->GetDirection()[0] == 0.0);
  CHECK_EQUAL(displacement->GetOffset(), 0.0);
  CHECK_EQUAL(displacement->GetScale(), 1.0);
  source->SetExaggeration(2.5);
  CHECK_EQUAL(displacement->GetScale(), 2.5);
  RelevoErrors errors(source);
  source->SetExaggeration(std::numeric_limits<double>::quiet_NaN());
  CHECK(errors.Said("Exaggeration must be in [-1e+38, 1e+38], got") &&
    source->GetExaggeration() == 2.5);
  source->SetNoDataPolicy(7);
  CHECK(errors.Said("NoDataPolicy must be one of HOLE (0), FILL (1), got") &&
    source->GetNoDataPolicy() == vtkDisplacement::HOLE);

  const RelevoRaster raster = MakeRaster(16, 16, { 0.0, 1.0, 0.0, 16.0, 0.0, -1.0 }, "EPSG:32633");
  const std::string name = folders.File("TerrainRecipe.tif");
  CHECK(raster.Write(name));
  source->SetFileName(name.c_str());
  CHECK_EQUAL(std::string(source->GetFileName()), name);
  source->Update();
  CHECK_EQUAL(source->GetDisplacement(), displacement);
  CHECK_EQUAL(displacement->GetScale(), 2.5);
  const vtkMTimeType before = source->GetOutput()->GetMTime();
  source->Update(); // nothing has changed, so it does not execute
  CHECK_EQUAL(source->GetOutput()->GetMTime(), before);
  source->SetNoDataValue(100.0); // the sample in the north-western corner
  source->Update();
  CHECK(source->GetOutput()->GetMTime() > before && source->GetHeightMap()->HasNoData());
}

void TestRealFiles(RelevoCheck& check, const RelevoTestFolders& folders)
{
  vtkNew<vtkTerrainSource> source;
  source->SetResolution(64);
  double bounds[6];

  source->SetFileName((folders.RealData + "rmnp-dem.tif").c_str());
  source->Update();
  CheckMesh(check, source->GetOutput());
  source->GetOutput()->GetBounds(bounds);
  const auto& earth = GeographicLib::Geodesic::WGS84();
  double width = 0.0;
  double height = 0.0;
  // By gdalinfo, the raster has 152 x 187 pixels of 0.00275 x 0.00211 degrees from 105.9125 W,
  // 40.553678 N.
  earth.Inverse(40.159108, -105.9125, 40.159108, -105.4945, width);
  earth.Inverse(40.159108, -105.7035, 40.553678, -105.7035, height);
  CHECK_NEAR((bounds[1] - bounds[0]) / width, 1.0, 1e-4);
  CHECK_NEAR((bounds[3] - bounds[2]) / height, 1.0, 1e-3); // the edges are curved

  source->SetFileName((folders.RealData + "SainteHelens.dem").c_str());
  source->Update();
  CHECK_GREATER(source->GetOutput()->GetNumberOfCells(), 0);
  source->GetOutput()->GetBounds(bounds);
  // All four corners lie outside the quadrangle. The hole ends within one coarse square.
  CHECK(bounds[0] >= -0.5 * 327 * 30 && bounds[0] < -0.5 * 327 * 30 + 400.0);
  source->SetNoDataPolicyToFill();
  source->Update();
  source->GetOutput()->GetBounds(bounds);
  CHECK(bounds[1] - bounds[0] == 327 * 30 && bounds[3] - bounds[2] == 468 * 30);
  CHECK(source->GetOrigin()[0] == 562710.0 && source->GetOrigin()[1] == 5114985.0);

  source->SetFileName((folders.RealData + "N57E011.hgt").c_str());
  source->Update();
  CheckMesh(check, source->GetOutput());
  CHECK_NEAR(source->GetOrigin()[0], 11.5, 1e-9);
  CHECK_NEAR(source->GetOrigin()[1], 57.5, 1e-9);
  const vtkIdType corner = FindPoint(source->GetOutput(), 1.0, 1.0);
  const auto expected = RelevoEastNorthUp(12.0 + 0.5 / 1200.0, 58.0 + 0.5 / 1200.0, 11.5, 57.5);
  CHECK_NEAR(Coordinate(source->GetOutput(), corner, 0), expected[0], 0.01);
  CHECK_NEAR(Coordinate(source->GetOutput(), corner, 1), expected[1], 0.01);
}
}

int TestTerrainSource(int argc, char* argv[])
{
  const RelevoTestFolders folders(argc, argv);
  RelevoCheck check;
  TestGeographic(check, folders);
  TestEllipsoid(check, folders);
  TestProjected(check, folders);
  TestFeet(check, folders);
  TestWithoutGeoreference(check, folders);
  TestOrientations(check, folders);
  TestNoData(check, folders);
  TestThin(check, folders);
  TestRecipe(check, folders);
  if (folders.RealData.empty())
  {
    std::cout << "No relief in RELEVO_TEST_DATA: only generated files are tested.\n";
  }
  else
  {
    TestRealFiles(check, folders);
  }
  return check.GetResult();
}
