// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkGeographicVectors promises an error that names the cause and an empty output for input that it
// cannot use.
#include "RelevoBlocks.h"
#include "RelevoCheck.h"
#include "RelevoGeographicMesh.h"

#include "vtkCellData.h"
#include "vtkExecutive.h"
#include "vtkGeographicVectors.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkTable.h"
#include "vtkTerrainSource.h"

#include <limits>

namespace
{
struct Case
{
  vtkNew<vtkGeographicVectors> Filter;
  vtkSmartPointer<vtkPolyData> Mesh = RelevoMakePoints({ { 0.0, 0.0 }, { 1.0, 0.0 } });

  Case()
  {
    this->Mesh->GetPointData()->AddArray(RelevoMakeArray("Wind", { { 1.0, 2.0 }, { 3.0, 4.0 } }));
    this->Filter->SetInputData(this->Mesh);
  }

  bool Says(const std::string& words)
  {
    RelevoErrors errors(this->Filter);
    RelevoErrors executive(this->Filter->GetExecutive());
    this->Filter->Modified();
    this->Filter->Update();
    return errors.Said(words) && this->Filter->GetOutput()->GetNumberOfPoints() == 0;
  }

  void Choose(int port, int association, const char* name)
  {
    this->Filter->SetInputArrayToProcess(0, port, 0, association, name);
  }
};

vtkSmartPointer<vtkImageData> MakeImage(int depth, vtkIdType tuples, int components)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(2, 2, depth);
  image->GetPointData()->AddArray(RelevoMakeArray(
    "Raster", std::vector<std::vector<double>>(tuples, std::vector<double>(components, 1.0))));
  return image;
}

void TestArrays(RelevoCheck& check)
{
  const int ofPoints = vtkDataObject::FIELD_ASSOCIATION_POINTS;
  Case none;
  none.Mesh->GetPointData()->Initialize();
  CHECK(none.Says("mesh has no point array of 2 or 3 components"));

  Case chosen;
  chosen.Choose(0, ofPoints, "Storm");
  CHECK(chosen.Says("mesh has no point array of numbers named \"Storm\""));
  chosen.Choose(1, ofPoints, "Wind");
  CHECK(chosen.Says("input 1"));
  chosen.Choose(7, ofPoints, "Wind");
  CHECK(chosen.Says("input 7"));
  chosen.Mesh->GetPointData()->AddArray(RelevoMakeArray("Speed", { { 1.0 }, { 2.0 } }));
  chosen.Choose(0, ofPoints, "Speed");
  CHECK(chosen.Says("\"Speed\" of the mesh has 1 components"));
  chosen.Mesh->GetCellData()->AddArray(RelevoMakeArray("Cells", { { 1.0, 2.0 } }));
  chosen.Choose(0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "Cells");
  CHECK(chosen.Says("The mesh has no point array \"Cells\", but a cell array of that name. Convert "
                    "it with vtkCellDataToPointData."));
  chosen.Mesh->GetPointData()->AddArray(RelevoMakeArray("Short", { { 1.0, 2.0 } }));
  chosen.Choose(0, ofPoints, "Short");
  CHECK(chosen.Says("\"Short\" has 1 tuples, but there are 2 points"));
}

void TestImages(RelevoCheck& check)
{
  Case item;
  item.Filter->SetRasterData(MakeImage(1, 4, 2));
  CHECK(item.Says("texture coordinates"));
  item.Mesh->GetPointData()->SetTCoords(
    RelevoMakeArray("TextureCoordinates", { { 0.0, 0.0 }, { 1.0, 1.0 } }));
  item.Filter->SetRasterData(MakeImage(1, 4, 4));
  CHECK(item.Says("image has no point array"));
  item.Filter->SetRasterData(MakeImage(1, 3, 2));
  CHECK(item.Says("3 tuples, but there are 4 points"));
  item.Filter->SetRasterData(MakeImage(2, 8, 2));
  CHECK(item.Says("2 x 2 x 2"));
  vtkNew<vtkImageData> empty;
  item.Filter->SetRasterData(empty);
  CHECK(item.Says("image has no point array"));
  item.Filter->SetRasterData(MakeImage(1, 4, 2));
  item.Filter->Update();
  CHECK_EQUAL(item.Filter->GetOutput()->GetNumberOfPoints(), 2);
  item.Filter->SetRasterData(nullptr);
  item.Filter->Update();
  CHECK_EQUAL(RelevoVectorOf(item.Filter->GetOutput(), 1, "Wind")[0], 3.0);
}

void TestSystems(RelevoCheck& check)
{
  Case item;
  item.Filter->SetCoordinateSystem("EPSG:999999");
  CHECK(item.Says("\"EPSG:999999\" cannot be used"));
  item.Filter->SetCoordinateSystem("nonsense");
  CHECK(item.Says("\"nonsense\" cannot be used"));
  item.Filter->SetCoordinateSystem("EPSG:4978"); // geocentric
  CHECK(item.Says("neither longitude and latitude nor"));
  item.Filter->SetCoordinateSystem("EPSG:32633");
  item.Filter->SetOrigin(500000.0, 0.0, 0.0);
  item.Filter->Update();
  CHECK_EQUAL(item.Filter->GetOutput()->GetNumberOfPoints(), 2);
  RelevoErrors errors(item.Filter);
  item.Filter->SetOrigin(std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0);
  CHECK(errors.Said("Origin must be a finite number") && item.Filter->GetOrigin()[0] == 500000.0);
  item.Filter->SetExaggeration(std::numeric_limits<double>::infinity());
  CHECK(errors.Said("Exaggeration must be in [") && item.Filter->GetExaggeration() == 1.0);
}

void TestTerrain(RelevoCheck& check)
{
  Case item;
  vtkNew<vtkTerrainSource> terrain;
  RelevoErrors errors(terrain);
  RelevoErrors executive(terrain->GetExecutive());
  terrain->SetFileName("nowhere.tif");
  item.Filter->SetTerrain(terrain);
  CHECK(item.Says("terrain has no mesh"));
  CHECK(errors.Said("nowhere.tif"));
  item.Filter->SetTerrain(nullptr);
  item.Filter->Update();
  CHECK_EQUAL(item.Filter->GetOutput()->GetNumberOfPoints(), 2);
}

void TestBlocks(RelevoCheck& check)
{
  Case item;
  CHECK(RelevoRefusesBlock(
    item.Filter, 0, vtkNew<vtkTable>(), "The input is a vtkTable; a vtkPolyData is needed."));
  item.Filter->SetInputData(item.Mesh);
  CHECK(RelevoRefusesBlock(item.Filter, 1, vtkNew<vtkPolyData>(),
    "The input of port 1 is a vtkPolyData; a vtkImageData is needed."));
}
}

int TestGeographicVectorsErrors(int, char*[])
{
  RelevoCheck check;
  TestArrays(check);
  TestImages(check);
  TestSystems(check);
  TestTerrain(check);
  TestBlocks(check);
  return check.GetResult();
}
