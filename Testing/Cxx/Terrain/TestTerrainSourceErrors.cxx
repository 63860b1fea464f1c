// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkTerrainSource: bad input gives an error of its own, an empty output and a failed request.
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

int TestTerrainSourceErrors(int argc, char* argv[])
{
  const RelevoTestFolders folders(argc, argv);
  RelevoCheck check;
  RelevoRaster raster;
  raster.Width = 36;
  raster.Height = 18;
  raster.SetValues([](int, int column, int row) { return column + row; });
  raster.Transform = { 10.0, 0.1, 0.0, 50.0, 0.0, -0.1 };
  raster.CoordinateSystem = "EPSG:4326";
  const std::string good = folders.File("TerrainErrorsGood.tif");
  CHECK(raster.Write(good));

  vtkNew<vtkTerrainSource> source;
  RelevoErrors errors(source);
  RelevoErrors executive(source->GetExecutive()); // it tells every failure once more
  const auto fails = [&](const std::string& name, const std::string& reason)
  {
    source->SetFileName(name.c_str());
    CHECK(source->GetExecutive()->Update() == 0);
    if (!CHECK(errors.Said(reason)))
    {
      std::cerr << "  for " << name << "\n";
    }
    CHECK(source->GetOutput()->GetNumberOfPoints() == 0);
    CHECK(source->GetOutput()->GetNumberOfCells() == 0);
    CHECK(std::string(source->GetCoordinateSystem()).empty());
  };
  const auto works = [&]
  {
    source->SetFileName(good.c_str());
    CHECK(source->GetExecutive()->Update() == 1 && errors.None());
    CHECK(source->GetOutput()->GetNumberOfCells() > 0);
  };

  CHECK(source->GetExecutive()->Update() == 0);
  CHECK(errors.Said("neither a file name nor an image"));
  works();
  fails(folders.File("no such terrain.tif"), "no such terrain.tif: the file does not exist");
  works();
  std::ofstream(folders.File("TerrainEmpty.hgt")).close();
  fails(folders.File("TerrainEmpty.hgt"), "the file is empty");
  std::ofstream(folders.File("TerrainText.tif")) << "text";
  fails(folders.File("TerrainText.tif"), "TerrainText.tif");
  RelevoTruncate(good, folders.File("TerrainHalf.tif"), 0.6);
  fails(folders.File("TerrainHalf.tif"), "TerrainHalf.tif");

  RelevoRaster bad = raster;
  bad.NoData = -1.0;
  std::fill(bad.Values.begin(), bad.Values.end(), -1.0);
  CHECK(bad.Write(folders.File("TerrainVoid.tif")));
  fails(folders.File("TerrainVoid.tif"), "none of the 648 heights has data");
  bad = raster;
  bad.Values[40] = std::numeric_limits<double>::quiet_NaN();
  CHECK(bad.Write(folders.File("TerrainNaN.tif")));
  fails(folders.File("TerrainNaN.tif"),
    "1 of 648 heights are NaN or infinite, the first in column 4, row 1");
  source->SetNoDataValue(std::numeric_limits<double>::quiet_NaN());
  CHECK(source->GetExecutive()->Update() == 1 && errors.None());

  // The whole earth does not lie on one tangent plane.
  bad = raster;
  bad.Transform = { -180.0, 10.0, 0.0, 90.0, 0.0, -10.0 };
  CHECK(bad.Write(folders.File("TerrainEarth.tif")));
  fails(folders.File("TerrainEarth.tif"), "beyond the horizon");
  bad.CoordinateSystem = "EPSG:4978";
  CHECK(bad.Write(folders.File("TerrainGeocentric.tif")));
  fails(folders.File("TerrainGeocentric.tif"), "project it first");
  // What headers tell is told before the heights are read, which are none here.
  for (const char* name : { "TerrainEarth", "TerrainGeocentric" })
  {
    const std::string half = folders.File(std::string(name) + "Half.tif");
    RelevoTruncate(folders.File(std::string(name) + ".tif"), half, 0.6);
    fails(half, name == std::string("TerrainEarth") ? "beyond the horizon" : "project it first");
  }
  source->SetImageryFileName("no such picture.tif");
  fails(folders.File("TerrainHalf.tif"), "no such picture.tif: the file does not exist");
  source->SetImageryFileName(nullptr);
  works();

  // A stop is no error, and leaves nothing half done.
  vtkNew<vtkCallbackCommand> observer;
  observer->SetCallback([](vtkObject* caller, unsigned long, void*, void*)
    { static_cast<vtkAlgorithm*>(caller)->AbortExecuteOn(); });
  const unsigned long tag = source->AddObserver(vtkCommand::ProgressEvent, observer);
  source->SetResolution(5);
  source->SetFileName(folders.File("TerrainNaN.tif").c_str());
  source->Update();
  CHECK(errors.None() && source->GetOutput()->GetNumberOfPoints() == 0);
  source->RemoveObserver(tag);
  source->SetAbortExecute(0);
  source->Modified();
  source->Update();
  CHECK(errors.None() && source->GetOutput()->GetNumberOfCells() > 0);
  return check.GetResult();
}
