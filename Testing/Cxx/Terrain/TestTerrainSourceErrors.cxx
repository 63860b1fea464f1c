// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkTerrainSource promises an error, an empty output and a failed request for invalid input.
#include "RelevoCheck.h"
#include "RelevoRasterFiles.h"

#include "vtkCallbackCommand.h"
#include "vtkExecutive.h"
#include "vtkHeightMap.h"
#include "vtkPolyData.h"
#include "vtkTerrainSource.h"

#include <fstream>
#include <iostream>
#include <limits>

namespace
{
// A source that reads a valid file between invalid ones, and the raster of that file.
struct Scene
{
  Scene(RelevoCheck& check, const RelevoTestFolders& folders)
    : Good(folders.File("TerrainErrorsGood.tif"))
  {
    this->Raster.Width = 36;
    this->Raster.Height = 18;
    this->Raster.SetValues([](int, int column, int row) { return column + row; });
    this->Raster.Transform = { 10.0, 0.1, 0.0, 50.0, 0.0, -0.1 };
    this->Raster.CoordinateSystem = "EPSG:4326";
    CHECK(this->Raster.Write(this->Good));
  }
  void Fails(RelevoCheck& check, const std::string& name, const std::string& reason)
  {
    this->Source->SetFileName(name.c_str());
    CHECK_EQUAL(this->Source->GetExecutive()->Update(), 0);
    if (!CHECK(this->Errors.Said(reason)))
    {
      std::cerr << "  for " << name << "\n";
    }
    CHECK_EQUAL(this->Source->GetOutput()->GetNumberOfPoints(), 0);
    CHECK_EQUAL(this->Source->GetOutput()->GetNumberOfCells(), 0);
    CHECK(std::string(this->Source->GetCoordinateSystem()).empty());
  }
  void Works(RelevoCheck& check)
  {
    this->Source->SetFileName(this->Good.c_str());
    CHECK(this->Source->GetExecutive()->Update() == 1 && this->Errors.None());
    CHECK_GREATER(this->Source->GetOutput()->GetNumberOfCells(), 0);
  }

  std::string Good;
  RelevoRaster Raster;
  vtkNew<vtkTerrainSource> Source;
  RelevoErrors Errors{ this->Source };
  RelevoErrors Executive{ this->Source->GetExecutive() }; // repeats every error
};

void TestNoRasters(RelevoCheck& check, const RelevoTestFolders& folders, Scene& scene)
{
  CHECK_EQUAL(scene.Source->GetExecutive()->Update(), 0);
  CHECK(scene.Errors.Said("There is no file name: call SetFileName()."));
  scene.Works(check);
  scene.Fails(
    check, folders.File("no such terrain.tif"), "no such terrain.tif: the file does not exist");
  scene.Works(check);
  std::ofstream(folders.File("TerrainEmpty.hgt")).close();
  scene.Fails(check, folders.File("TerrainEmpty.hgt"), "the file is empty");
  std::ofstream(folders.File("TerrainText.tif")) << "text";
  scene.Fails(check, folders.File("TerrainText.tif"), "TerrainText.tif");
  RelevoTruncate(scene.Good, folders.File("TerrainHalf.tif"), 0.6);
  scene.Fails(check, folders.File("TerrainHalf.tif"), "TerrainHalf.tif");
}

// A raster without data, and NaN, which may be the no-data value.
void TestHeights(RelevoCheck& check, const RelevoTestFolders& folders, Scene& scene)
{
  RelevoRaster bad = scene.Raster;
  bad.NoData = -1.0;
  std::fill(bad.Values.begin(), bad.Values.end(), -1.0);
  CHECK(bad.Write(folders.File("TerrainVoid.tif")));
  scene.Fails(check, folders.File("TerrainVoid.tif"), "all 648 heights are missing values");
  bad = scene.Raster;
  bad.Values[40] = std::numeric_limits<double>::quiet_NaN();
  CHECK(bad.Write(folders.File("TerrainNaN.tif")));
  scene.Fails(check, folders.File("TerrainNaN.tif"),
    "1 of 648 heights are NaN or infinite, the first in column 4, row 1");
  scene.Source->SetNoDataValue(std::numeric_limits<double>::quiet_NaN());
  CHECK(scene.Source->GetExecutive()->Update() == 1 && scene.Errors.None());
}

// The whole earth does not fit onto one tangent plane.
void TestPlaces(RelevoCheck& check, const RelevoTestFolders& folders, Scene& scene)
{
  RelevoRaster bad = scene.Raster;
  bad.Transform = { -180.0, 10.0, 0.0, 90.0, 0.0, -10.0 };
  CHECK(bad.Write(folders.File("TerrainEarth.tif")));
  scene.Fails(check, folders.File("TerrainEarth.tif"), "beyond the horizon");
  bad.Transform = { 500000.0, 30.0, 0.0, 4300000.0, 0.0, -30.0 };
  CHECK(bad.Write(folders.File("TerrainMetres.tif")));
  scene.Fails(check, folders.File("TerrainMetres.tif"), "latitudes beyond the poles");
  bad.Transform = { -180.0, 10.0, 0.0, 90.0, 0.0, -10.0 };
  bad.CoordinateSystem = "EPSG:4978";
  CHECK(bad.Write(folders.File("TerrainGeocentric.tif")));
  scene.Fails(check, folders.File("TerrainGeocentric.tif"), "project it first");
  // Errors in headers are reported before heights are read, which these files lack.
  for (const char* name : { "TerrainEarth", "TerrainGeocentric" })
  {
    const std::string half = folders.File(std::string(name) + "Half.tif");
    RelevoTruncate(folders.File(std::string(name) + ".tif"), half, 0.6);
    scene.Fails(
      check, half, name == std::string("TerrainEarth") ? "beyond the horizon" : "project it first");
  }
  scene.Source->SetImageryFileName("no such picture.tif");
  scene.Fails(
    check, folders.File("TerrainHalf.tif"), "no such picture.tif: the file does not exist");
  scene.Source->SetImageryFileName(nullptr);
  scene.Works(check);
}

// Aborting is not an error and leaves no partial result.
void TestStop(RelevoCheck& check, const RelevoTestFolders& folders, Scene& scene)
{
  vtkTerrainSource* source = scene.Source;
  vtkNew<vtkCallbackCommand> observer;
  observer->SetCallback([](vtkObject* caller, unsigned long, void*, void*)
    { static_cast<vtkAlgorithm*>(caller)->AbortExecuteOn(); });
  const unsigned long tag = source->AddObserver(vtkCommand::ProgressEvent, observer);
  source->SetResolution(5);
  source->SetFileName(folders.File("TerrainNaN.tif").c_str());
  source->Update();
  CHECK(scene.Errors.None() && source->GetOutput()->GetNumberOfPoints() == 0);
  source->RemoveObserver(tag);
  source->SetAbortExecute(0);
  source->Modified();
  source->Update();
  CHECK(scene.Errors.None() && source->GetOutput()->GetNumberOfCells() > 0);
}
}

int TestTerrainSourceErrors(int argc, char* argv[])
{
  const RelevoTestFolders folders(argc, argv);
  RelevoCheck check;
  Scene scene(check, folders);
  TestNoRasters(check, folders, scene);
  TestHeights(check, folders, scene);
  TestPlaces(check, folders, scene);
  TestStop(check, folders, scene);
  return check.GetResult();
}
