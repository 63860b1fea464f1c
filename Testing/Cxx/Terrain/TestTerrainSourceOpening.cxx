// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves that a raster is opened once for location and heights, so that replacing the file in
// between has no effect. Messages of height map and source are equal.
#include "RelevoCheck.h"
#include "RelevoRasterFiles.h"
#include "vtkCallbackCommand.h"
#include "vtkDisplacement.h"
#include "vtkExecutive.h"
#include "vtkHeightMap.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkTerrainSource.h"

#include <filesystem>

namespace
{
constexpr double FirstCorner = 500000.0;
constexpr double SecondCorner = 600000.0;

// Two rasters with different sizes, locations and heights. The second replaces the first file.
struct Files
{
  std::string Name;
  std::string Other;

  explicit Files(const RelevoTestFolders& folders)
    : Name(folders.File("TerrainOpening.tif"))
    , Other(folders.File("TerrainOpeningOther.tif"))
  {
  }
  bool Write() const
  {
    RelevoRaster raster;
    raster.CoordinateSystem = "EPSG:32633";
    raster.Width = 30;
    raster.Height = 20;
    raster.Transform = { FirstCorner, 10.0, 0.0, 5000000.0, 0.0, -10.0 };
    raster.SetValues([](int, int column, int) { return 100.0 + column; });
    const bool first = raster.Write(this->Name);
    raster.Width = 12;
    raster.Height = 12;
    raster.Transform = { SecondCorner, 30.0, 0.0, 5000000.0, 0.0, -30.0 };
    raster.SetValues([](int, int, int) { return 700.0; });
    return first && raster.Write(this->Other);
  }
  void Replace() const { std::filesystem::rename(this->Other, this->Name); }
};

// Whether all results come from the first raster.
void ExpectFirst(RelevoCheck& check, vtkTerrainSource* source)
{
  CHECK_EQUAL(source->GetExecutive()->Update(), 1);
  CHECK_GREATER(source->GetOutput()->GetNumberOfCells(), 0);
  CHECK_NEAR(source->GetOrigin()[0], FirstCorner + 150.0, 1e-9);
  CHECK_NEAR(source->GetOutput()->GetBounds()[1], 150.0, 1e-9);
  CHECK_EQUAL(source->GetHeightMap()->GetDimensions()[0], 30);
  CHECK_EQUAL(source->GetHeightMap()->GetRange()[0], 100.0);
  CHECK_EQUAL(source->GetHeightMap()->GetRange()[1], 129.0);
}

void TestOpenings(RelevoCheck& check, const RelevoTestFolders& folders)
{
  const Files files(folders);
  {
    // The source opens the file, and the height map reads it.
    CHECK(files.Write());
    vtkNew<vtkTerrainSource> source;
    source->SetFileName(files.Name.c_str());
    vtkNew<vtkCallbackCommand> replacing;
    replacing->SetClientData(const_cast<Files*>(&files));
    replacing->SetCallback(
      [](vtkObject* caller, unsigned long, void* client, void*)
      {
        // The location is known, but no height has been read.
        if (static_cast<vtkTerrainSource*>(caller)->GetProgressText() &&
          std::filesystem::exists(static_cast<Files*>(client)->Other))
        {
          static_cast<Files*>(client)->Replace();
        }
      });
    source->AddObserver(vtkCommand::ProgressEvent, replacing);
    ExpectFirst(check, source);
    CHECK(!std::filesystem::exists(files.Other));
  }
  {
    // The height map opens the file, and the source takes the location from it.
    CHECK(files.Write());
    vtkNew<vtkTerrainSource> source;
    source->SetFileName(files.Name.c_str());
    CHECK(source->GetHeightMap()->UpdateInformation());
    CHECK_EQUAL(source->GetHeightMap()->GetFullDimensions()[0], 30);
    files.Replace();
    ExpectFirst(check, source);
  }
  {
    // The same after the heights were read.
    CHECK(files.Write());
    vtkNew<vtkTerrainSource> source;
    source->SetFileName(files.Name.c_str());
    CHECK(source->GetHeightMap()->Update());
    files.Replace();
    ExpectFirst(check, source);
    // Another mesh of the same raster does not need the file.
    std::filesystem::remove(files.Name);
    source->SetResolution(3);
    ExpectFirst(check, source);
    // Modified() makes the source open the file again.
    CHECK(files.Write());
    files.Replace();
    source->GetHeightMap()->Modified();
    CHECK_EQUAL(source->GetExecutive()->Update(), 1);
    CHECK_NEAR(source->GetOrigin()[0], SecondCorner + 180.0, 1e-9);
    CHECK_EQUAL(source->GetHeightMap()->GetRange()[1], 700.0);
  }
}

// Released heights are read again on demand, from the current file.
void TestReleasedHeights(RelevoCheck& check, const RelevoTestFolders& folders)
{
  const Files files(folders);
  CHECK(files.Write());
  vtkNew<vtkTerrainSource> source;
  vtkHeightMap* heights = source->GetHeightMap();
  source->SetFileName(files.Name.c_str());
  source->KeepHeightsOff();
  CHECK_EQUAL(source->GetExecutive()->Update(), 1);
  CHECK_GREATER(source->GetOutput()->GetNumberOfCells(), 0);
  CHECK(heights->GetDimensions()[0] == 0 && !heights->GetSamples());
  CHECK(source->GetDisplacement()->Update());
  ExpectFirst(check, source);
  heights->ReleaseHeights();
  files.Replace();
  CHECK(
    heights->Update() && heights->GetDimensions()[0] == 12 && heights->GetSamples()[0] == 700.0f);
  source->SetResolution(3);
  CHECK_EQUAL(source->GetExecutive()->Update(), 1);
  CHECK(source->GetOutput()->GetNumberOfCells() == 18 && !heights->GetSamples());
}

// The next update finds a file that was missing.
void TestLateFile(RelevoCheck& check, const RelevoTestFolders& folders)
{
  const Files files(folders);
  std::filesystem::remove(files.Name);
  vtkNew<vtkTerrainSource> source;
  RelevoErrors errors(source);
  RelevoErrors executive(source->GetExecutive());
  source->SetFileName(files.Name.c_str());
  CHECK(source->GetExecutive()->Update() == 0 && errors.Said("the file does not exist"));
  CHECK(!source->GetHeightMap()->Update() && errors.Said("the file does not exist"));
  CHECK(files.Write());
  source->Modified();
  ExpectFirst(check, source);
  CHECK(errors.None());
}

// The object that fails and the object that owns it report the same message.
void TestMessages(RelevoCheck& check, const RelevoTestFolders& folders)
{
  vtkNew<vtkTerrainSource> source;
  vtkHeightMap* heights = source->GetHeightMap();
  CHECK(!*heights->GetErrorMessage() && !*heights->GetWarningMessage());
  {
    RelevoErrors errors(source);
    RelevoErrors executive(source->GetExecutive());
    // The name looks like the end of VTK's message prefix.
    source->SetFileName(folders.File("no (such): terrain.tif").c_str());
    source->Update();
    const std::string text = heights->GetErrorMessage();
    CHECK_EQUAL(
      text, "Cannot read " + folders.File("no (such): terrain.tif") + ": the file does not exist.");
    CHECK(errors.Said("): " + text + "\n"));
  }
  const Files files(folders);
  CHECK(files.Write());
  RelevoErrors warnings(source);
  source->SetFileName(files.Name.c_str());
  source->SetMaximumDimension(16);
  source->Update();
  CHECK(!*heights->GetErrorMessage());
  const std::string text = heights->GetWarningMessage();
  CHECK_EQUAL(text.find(files.Name + " has 30 x 20 heights"), 0);
  CHECK(warnings.Warned("): " + text + "\n"));
  source->SetMaximumDimension(64);
  source->Update();
  CHECK(!*heights->GetWarningMessage() && warnings.None());
}
}

int TestTerrainSourceOpening(int argc, char* argv[])
{
  const RelevoTestFolders folders(argc, argv);
  RelevoCheck check;
  TestOpenings(check, folders);
  TestReleasedHeights(check, folders);
  TestLateFile(check, folders);
  TestMessages(check, folders);
  return check.GetResult();
}
