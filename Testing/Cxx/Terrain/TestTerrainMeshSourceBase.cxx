// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// With a base, the mesh is a closed solid: each edge has two triangles, and the volume is that
// between the surface and the bottom. The surface is unchanged. The solid of a closed globe has no
// walls.
#include "RelevoCheck.h"
#include "RelevoRasterFiles.h"
#include "RelevoSanitizer.h"

#include "vtkCamera.h"
#include "vtkCell.h"
#include "vtkCleanPolyData.h"
#include "vtkDataArray.h"
#include "vtkFeatureEdges.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTerrainMeshSource.h"
#include "vtkTerrainPyramid.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
constexpr int Size = 120;

enum class Holes
{
  None,
  Few,     // with corners that touch, and islands
  Checkers // all corners touch
};

bool IsHole(Holes holes, int column, int row)
{
  if (holes == Holes::Checkers)
  {
    return (column / 8 + row / 8) % 2 == 0;
  }
  const double ring = std::hypot(column - 60, row - 50);
  return holes == Holes::Few &&
    ((ring > 18.0 && ring < 24.0) || column + row < 15 || (column / 5 == 3 && row % 10 < 6));
}

std::string WriteTerrain(RelevoCheck& check, const RelevoTestFolders& folders, Holes holes)
{
  RelevoRaster raster;
  raster.Width = Size;
  raster.Height = Size;
  raster.Transform = { 500000.0, 10.0, 0.0, 4200000.0, 0.0, -10.0 };
  raster.CoordinateSystem = "EPSG:32633";
  raster.NoData = -9999.0;
  raster.SetValues(
    [holes](int, int column, int row)
    {
      return IsHole(holes, column, row) ? -9999.0
                                        : 100.0 +
          30.0 * std::sin(column / 7.0) * std::cos(row / 11.0) + (column * 7 + row * 13) % 5;
    });
  const std::string file = folders.File("TerrainMeshSourceBase.tif");
  CHECK(raster.Write(file));
  return file;
}

// The volume above z = 0 by the divergence theorem, and the part of the mesh above another mesh.
double GetVolume(vtkPolyData* mesh)
{
  double volume = 0.0;
  for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
  {
    vtkCell* cell = mesh->GetCell(i);
    double points[3][3];
    for (int corner = 0; corner < 3; ++corner)
    {
      mesh->GetPoint(cell->GetPointId(corner), points[corner]);
    }
    const double area = 0.5 *
      ((points[1][0] - points[0][0]) * (points[2][1] - points[0][1]) -
        (points[2][0] - points[0][0]) * (points[1][1] - points[0][1]));
    volume += area * (points[0][2] + points[1][2] + points[2][2]) / 3.0;
  }
  return volume;
}

double GetArea(vtkPolyData* mesh)
{
  vtkNew<vtkPolyData> flat;
  flat->DeepCopy(mesh);
  for (vtkIdType i = 0; i < flat->GetNumberOfPoints(); ++i)
  {
    double point[3];
    flat->GetPoint(i, point);
    flat->GetPoints()->SetPoint(i, point[0], point[1], 1.0);
  }
  return GetVolume(flat);
}

void CheckClosed(RelevoCheck& check, vtkPolyData* solid)
{
  CHECK_GREATER(solid->GetNumberOfCells(), 10);
  vtkNew<vtkFeatureEdges> edges;
  edges->SetInputData(solid);
  edges->BoundaryEdgesOn();
  edges->NonManifoldEdgesOn();
  edges->FeatureEdgesOff();
  edges->ManifoldEdgesOff();
  edges->Update();
  CHECK_EQUAL(edges->GetOutput()->GetNumberOfCells(), 0);
}

void CheckSolid(RelevoCheck& check, vtkTerrainMeshSource* source, double base, double z)
{
  source->UseBaseOff();
  source->Update();
  vtkNew<vtkPolyData> surface;
  surface->DeepCopy(source->GetOutput());
  CHECK_GREATER(surface->GetNumberOfCells(), 10);
  source->UseBaseOn();
  source->SetBaseHeight(base);
  source->Update();
  vtkPolyData* solid = source->GetOutput();
  CheckClosed(check, solid);
  // The surface, to the bit
  CHECK_GREATER(solid->GetNumberOfCells(), 2 * surface->GetNumberOfCells());
  bool isSame = true;
  for (vtkIdType i = 0; i < surface->GetNumberOfCells(); ++i)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      double points[2][3];
      surface->GetPoint(surface->GetCell(i)->GetPointId(corner), points[0]);
      solid->GetPoint(solid->GetCell(i)->GetPointId(corner), points[1]);
      isSame = isSame && std::equal(points[0], points[0] + 3, points[1]);
    }
  }
  CHECK(isSame);
  // Triangles face outwards.
  const double expected = GetVolume(surface) - z * GetArea(surface);
  CHECK_NEAR(GetVolume(solid) / expected, 1.0, 1e-9);
  CHECK_EQUAL(solid->GetBounds()[4], z);
  vtkDataArray* heights = solid->GetPointData()->GetArray("Height");
  CHECK_EQUAL(heights->GetNumberOfTuples(), solid->GetNumberOfPoints());
  CHECK_EQUAL(heights->GetRange()[0], base);
  CHECK_EQUAL(solid->GetPointData()->GetTCoords()->GetNumberOfTuples(), solid->GetNumberOfPoints());
}

void TestErrors(RelevoCheck& check, vtkTerrainMeshSource* source)
{
  RelevoErrors errors(source);
  source->UseBaseOn();
  source->SetBaseHeight(200.0);
  source->Update();
  CHECK(errors.Said("BaseHeight is 200"));
  CHECK_EQUAL(source->GetOutput()->GetNumberOfCells(), 0);
  source->SetBaseHeight(std::numeric_limits<double>::infinity());
  CHECK(errors.Said("BaseHeight"));
  CHECK_EQUAL(source->GetBaseHeight(), 200.0);
}

// Points of the bottom are below those of the surface along the normal of the ellipsoid.
void CheckGeocentric(RelevoCheck& check, vtkTerrainMeshSource* source)
{
  source->SetFrameToGeocentric();
  source->SetMaximumError(1.0);
  source->SetBaseHeight(10.0);
  source->Update();
  vtkPolyData* solid = source->GetOutput();
  CheckClosed(check, solid);
  const vtkIdType points = solid->GetNumberOfPoints() / 2;
  vtkDataArray* heights = solid->GetPointData()->GetArray("Height");
  double largest = 0.0;
  for (vtkIdType i = 0; i < points; ++i)
  {
    double ends[2][3];
    solid->GetPoint(i, ends[0]);
    solid->GetPoint(points + i, ends[1]);
    const double depth = source->GetExaggeration() * (heights->GetTuple1(i) - 10.0);
    const double distance = std::sqrt(vtkMath::Distance2BetweenPoints(ends[0], ends[1]));
    vtkMath::Subtract(ends[0], ends[1], ends[1]);
    vtkMath::Normalize(ends[0]);
    const double across = std::sin(vtkMath::AngleBetweenVectors(ends[0], ends[1]));
    largest = std::max({ largest, std::abs(distance - depth), 100.0 * (across - 0.0035) });
  }
  CHECK_LESS(largest, 1e-6); // the normal differs from the radius by at most 0.2 degrees
}

std::string WriteGlobe(RelevoCheck& check, const RelevoTestFolders& folders, bool hasHole)
{
  RelevoRaster raster;
  raster.Width = 120;
  raster.Height = 60;
  raster.Transform = { -180.0, 3.0, 0.0, 90.0, 0.0, -3.0 };
  raster.CoordinateSystem = "EPSG:4326";
  raster.NoData = -9999.0;
  raster.SetValues(
    [hasHole](int, int column, int row)
    {
      const bool isHole = hasHole && row > 20 && row < 30 && (column < 4 || column > 110);
      return isHole ? -9999.0 : 3000.0 * std::sin(column * vtkMath::Pi() / 20.0 + row / 9.0);
    });
  const std::string file = folders.File("TerrainMeshSourceBaseGlobe.tif");
  CHECK(raster.Write(file));
  return file;
}

// The solid of a globe is closed once points are merged. Returns its number of walls.
vtkIdType CheckGlobe(RelevoCheck& check, vtkTerrainMeshSource* source)
{
  source->UseBaseOff();
  source->Update();
  const vtkIdType triangles = source->GetOutput()->GetNumberOfPolys();
  source->UseBaseOn();
  source->SetBaseHeight(-20000.0);
  source->Update();
  const vtkIdType walls = source->GetOutput()->GetNumberOfPolys() - 2 * triangles;
  vtkNew<vtkCleanPolyData> merged;
  merged->SetInputData(source->GetOutput());
  merged->ToleranceIsAbsoluteOn();
  merged->SetAbsoluteTolerance(0.0);
  merged->Update();
  CHECK_EQUAL(merged->GetOutput()->GetNumberOfPolys(), source->GetOutput()->GetNumberOfPolys());
  CHECK_EQUAL(merged->GetOutput()->GetNumberOfLines(), 0); // of triangles without area
  CheckClosed(check, merged->GetOutput());
  return walls;
}

void TestGlobe(RelevoCheck& check, const RelevoTestFolders& folders)
{
  for (bool hasHole : { false, true })
  {
    CHECK_CASE(hasHole);
    vtkNew<vtkTerrainPyramid> pyramid;
    pyramid->SetFileName(WriteGlobe(check, folders, hasHole).c_str());
    vtkNew<vtkTerrainMeshSource> source;
    source->SetPyramid(pyramid);
    source->SetFrameToGeocentric();
    for (double error : { 500.0, 5000.0 })
    {
      if (RelevoHasAddressSanitizer && error == 500.0)
      {
        continue;
      }
      source->SetMaximumError(error);
      const vtkIdType walls = CheckGlobe(check, source);
      CHECK_EQUAL(walls > 0, hasHole);
    }
    // Half of the globe has walls along two meridians.
    source->SetRegion(-180.0, 0.0, -90.0, 90.0);
    CHECK_GREATER(CheckGlobe(check, source), 0);
    source->SetRegion(1.0, -1.0, 1.0, -1.0);
    RelevoErrors errors(source);
    source->SetExaggeration(1000.0);
    source->Update();
    CHECK(errors.Said("the centre of the globe"));
  }
}
}

int TestTerrainMeshSourceBase(int argc, char* argv[])
{
  RelevoCheck check;
  const RelevoTestFolders folders(argc, argv);
  for (Holes holes : { Holes::None, Holes::Few, Holes::Checkers })
  {
    if (RelevoHasAddressSanitizer && holes == Holes::Checkers)
    {
      continue; // the same code takes long
    }
    CHECK_CASE(static_cast<int>(holes));
    vtkNew<vtkTerrainPyramid> pyramid;
    pyramid->SetFileName(WriteTerrain(check, folders, holes).c_str());
    vtkNew<vtkTerrainMeshSource> source;
    source->SetPyramid(pyramid);
    source->SetMaximumError(1.0);
    CheckSolid(check, source, 0.0, 0.0);
    source->SetExaggeration(2.0);
    CheckSolid(check, source, 20.0, 40.0);
    source->SetRegion(500205.0, 500805.0, 4199105.0, 4199605.0);
    source->SetMaximumError(0.01);
    CheckSolid(check, source, -50.0, -100.0);
    vtkNew<vtkCamera> camera;
    camera->SetPosition(-400.0, -900.0, 600.0);
    camera->SetFocalPoint(0.0, 0.0, 100.0);
    camera->SetViewUp(0.0, 0.0, 1.0);
    camera->SetClippingRange(10.0, 3000.0);
    camera->SetViewAngle(90.0); // sees all parts
    source->SetCamera(camera);
    source->SetMaximumError(0.0);
    source->SetViewportSize(300, 200);
    CheckSolid(check, source, 0.0, 0.0);
    // Also the surface above walls in sight
    camera->SetViewAngle(20.0);
    camera->SetFocalPoint(0.0, -400.0, 0.0);
    source->UseBaseOff();
    source->Update();
    const vtkIdType triangles = source->GetOutput()->GetNumberOfCells();
    source->UseBaseOn();
    source->SetBaseHeight(-1000.0);
    source->Update();
    CheckClosed(check, source->GetOutput());
    CHECK_GREATER(source->GetOutput()->GetNumberOfCells(), 2 * triangles);
    source->SetRegion(1.0, -1.0, 1.0, -1.0);
    CheckGeocentric(check, source);
    source->SetFrameToMap();
    if (holes == Holes::None)
    {
      TestErrors(check, source);
    }
  }
  TestGlobe(check, folders);
  return check.GetResult();
}
