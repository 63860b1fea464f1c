// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkTerrainSource promises that its mesh, refined with its displacement, is the relief.
#include "RelevoCheck.h"
#include "RelevoRasterFiles.h"

#include "vtkAdaptiveRefinement.h"
#include "vtkAdaptiveRefinementFilter.h"
#include "vtkDisplacement.h"
#include "vtkFieldData.h"
#include "vtkHeightMap.h"
#include "vtkIdList.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkTerrainSource.h"

#include <algorithm>
#include <cmath>
#include <iostream>

namespace
{
// Refines until a point is close to the centre of every texel.
vtkSmartPointer<vtkPolyData> Refine(vtkTerrainSource* source, int level)
{
  vtkNew<vtkAdaptiveRefinement> recipe;
  recipe->SetMaximumLevel(level);
  recipe->SetDisplacement(source->GetDisplacement());
  vtkNew<vtkAdaptiveRefinementFilter> filter;
  filter->SetInputConnection(source->GetOutputPort());
  filter->SetRefinement(recipe);
  filter->Update();
  vtkSmartPointer<vtkPolyData> mesh = filter->GetOutput();
  return mesh;
}

// Largest deviation of z from exaggeration x height at the points' texture coordinates.
double Deviation(vtkPolyData* mesh, vtkTerrainSource* source)
{
  vtkDataArray* texture = mesh->GetPointData()->GetTCoords();
  double worst = 0.0;
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    const double height =
      source->GetHeightMap()->GetHeight(texture->GetComponent(i, 0), texture->GetComponent(i, 1));
    worst = std::max(
      worst, std::abs(mesh->GetPoint(i)[2] - source->GetDisplacement()->GetScale() * height));
  }
  return worst;
}

// Number of triangles that do not face up.
int NumberOfOverhangs(vtkPolyData* mesh)
{
  int count = 0;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    mesh->GetCellPoints(cell, ids);
    double p[3][3];
    for (int i = 0; i < 3; ++i)
    {
      mesh->GetPoint(ids->GetId(i), p[i]);
    }
    count +=
      (p[1][0] - p[0][0]) * (p[2][1] - p[0][1]) - (p[2][0] - p[0][0]) * (p[1][1] - p[0][1]) <= 0.0;
  }
  return count;
}

// The mesh's field data contain the raster's centre and coordinate system.
void CheckPlace(RelevoCheck& check, vtkPolyData* mesh, vtkTerrainSource* source)
{
  vtkFieldData* data = mesh->GetFieldData();
  vtkDataArray* origin = data->GetArray("Origin");
  auto* system = vtkStringArray::SafeDownCast(data->GetAbstractArray("CoordinateSystem"));
  CHECK(data->GetNumberOfArrays() == 2 && origin && system);
  if (!origin || !system)
  {
    return;
  }
  CHECK_EQUAL(origin->GetNumberOfTuples(), 1);
  CHECK_EQUAL(origin->GetNumberOfComponents(), 3);
  CHECK_EQUAL(system->GetNumberOfValues(), 1);
  for (int i = 0; i < 3; ++i)
  {
    CHECK_EQUAL(origin->GetComponent(0, i), source->GetOrigin()[i]);
  }
  CHECK_EQUAL(system->GetValue(0), source->GetCoordinateSystem());
}

// A cone has missing data beside it.
void TestCone(RelevoCheck& check, const RelevoTestFolders& folders)
{
  RelevoRaster raster;
  raster.Width = 64;
  raster.Height = 48;
  raster.Transform = { 0.0, 10.0, 0.0, 480.0, 0.0, -10.0 };
  raster.CoordinateSystem = "EPSG:32633";
  raster.NoData = -9999.0;
  raster.SetValues(
    [](int, int column, int row)
    {
      return std::hypot(column - 50.0, row - 10.0) < 6.0
        ? -9999.0
        : 300.0 - 5.0 * std::hypot(column - 20.0, row - 24.0);
    });
  const std::string name = folders.File("TerrainRefined.tif");
  CHECK(raster.Write(name));
  vtkNew<vtkTerrainSource> source;
  source->SetFileName(name.c_str());
  source->SetResolution(8);
  source->SetExaggeration(2.0);
  source->Update();
  const auto holes = Refine(source, 4);
  CHECK_GREATER(holes->GetNumberOfCells(), 1000);
  CHECK_NEAR(Deviation(holes, source), 0.0, 0.02);
  CHECK_EQUAL(NumberOfOverhangs(holes), 0);
  CHECK(source->GetOrigin()[0] == 320.0 && source->GetOrigin()[1] == 240.0);
  CHECK_NOT_EQUAL(
    std::string(source->GetCoordinateSystem()).find("UTM zone 33N"), std::string::npos);
  CheckPlace(check, source->GetOutput(), source);
  CheckPlace(check, holes, source);
  double bounds[6];
  holes->GetBounds(bounds);
  CHECK(bounds[4] > 0.0 && bounds[5] <= 600.0 && bounds[5] > 590.0);
  vtkNew<vtkIdList> ids;
  vtkDataArray* texture = holes->GetPointData()->GetTCoords();
  int overVoid = 0;
  for (vtkIdType cell = 0; cell < holes->GetNumberOfCells(); ++cell)
  {
    holes->GetCellPoints(cell, ids);
    for (int i = 0; i < 3; ++i)
    {
      overVoid += !source->GetHeightMap()->IsValid(
        texture->GetComponent(ids->GetId(i), 0), texture->GetComponent(ids->GetId(i), 1));
    }
  }
  CHECK_EQUAL(overVoid, 0);

  source->SetNoDataPolicyToFill();
  source->Update();
  const auto full = Refine(source, 4);
  CHECK_EQUAL(full->GetNumberOfCells(), 2 * 8 * 6 * 256);
  CHECK_GREATER(full->GetNumberOfCells(), holes->GetNumberOfCells());
  CHECK_NEAR(Deviation(full, source), 0.0, 0.02);
  full->GetBounds(bounds);
  CHECK(bounds[4] > 0.0 && bounds[5] <= 600.0);
}
}

int TestTerrainSourceRefined(int argc, char* argv[])
{
  const RelevoTestFolders folders(argc, argv);
  RelevoCheck check;
  TestCone(check, folders);
  for (const char* name : { "rmnp-dem.tif", "SainteHelens.dem", "mt_rainier_90m.tif" })
  {
    CHECK_CASE(name);
    if (folders.RealData.empty())
    {
      break;
    }
    vtkNew<vtkTerrainSource> source;
    source->SetFileName((folders.RealData + name).c_str());
    source->SetResolution(32);
    source->Update();
    const auto mesh = Refine(source, 3);
    double bounds[6];
    mesh->GetBounds(bounds);
    std::cout << name << ": " << mesh->GetNumberOfCells() << " triangles, z " << bounds[4] << " to "
              << bounds[5] << "\n";
    CHECK_NEAR(Deviation(mesh, source), 0.0, 0.05);
    CHECK_EQUAL(NumberOfOverhangs(mesh), 0);
    CHECK_GREATER_EQUAL(bounds[4], source->GetHeightMap()->GetRange()[0]);
    CHECK_LESS_EQUAL(bounds[5], source->GetHeightMap()->GetRange()[1]);
  }
  return check.GetResult();
}
