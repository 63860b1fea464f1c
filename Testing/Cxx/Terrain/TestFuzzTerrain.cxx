// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves that random calls of the public classes of FiltersTerrain, on random images and small
// files, whole and truncated, never crash. Heights stay in their range, and points stay finite.
#include "RelevoCheck.h"
#include "RelevoFuzzImages.h"
#include "RelevoRasterFiles.h"

#include "vtkAdaptiveRefinement.h"
#include "vtkAdaptiveRefinementFilter.h"
#include "vtkDisplacement.h"
#include "vtkGeographicVectors.h"
#include "vtkHeightMap.h"
#include "vtkTerrainSource.h"

#include <cmath>
#include <sstream>

namespace
{
using RelevoFuzz::Call;
using RelevoFuzz::Dice;

// Files that WriteFiles() has written, and names without a valid file.
std::vector<std::string> Files = { "", "no such file.tif" };

void WriteFiles(const RelevoTestFolders& folders)
{
  Dice dice(7);
  const std::vector<std::string> systems = { "", "EPSG:4326", "EPSG:32633", "EPSG:4978" };
  for (int i = 0; i < 12; ++i)
  {
    RelevoRaster raster;
    raster.Width = 1 + dice.Throw(i % 3 == 0 ? 3 : 20);
    raster.Height = 1 + dice.Throw(20);
    raster.NumberOfBands = i % 4 == 3 ? 1 + dice.Throw(5) : 1;
    raster.Type = i % 3 == 0 ? GDT_Float32 : i % 3 == 1 ? GDT_Int16 : GDT_Byte;
    const bool isHostile = raster.Type == GDT_Float32 && i % 2 == 1;
    raster.SetValues([&](int, int column, int row)
      { return isHostile ? dice.Number() : 100.0 + column - 2.0 * row; });
    raster.CoordinateSystem = dice.Choose(systems);
    if (dice.Throw(4))
    {
      raster.Transform = { 10.0, dice.Once(6) ? 0.0 : 0.01, dice.Once(4) ? 0.002 : 0.0, 50.0, 0.0,
        dice.Once(4) ? 0.01 : -0.01 };
    }
    if (dice.Once(3))
    {
      raster.NoData = dice.Once(2) ? 99.0 : dice.Number();
    }
    const std::string whole = folders.File("FuzzTerrain" + std::to_string(i) + ".tif");
    const std::string half = folders.File("FuzzTerrainHalf" + std::to_string(i) + ".tif");
    if (raster.Write(whole))
    {
      RelevoTruncate(whole, half, dice.Share());
      Files.push_back(whole);
      Files.push_back(whole);
      Files.push_back(half);
    }
  }
}

// Rasters with random georeferences.
void WritePlaces(const RelevoTestFolders& folders)
{
  Dice dice(11);
  const std::vector<std::string> systems = { "", "EPSG:4326", "EPSG:32633",
    "GEOGCS[\"egg\",DATUM[\"egg\",SPHEROID[\"egg\",6378137,0.5]],PRIMEM[\"Greenwich\",0],"
    "UNIT[\"degree\",0.0174532925199433]]" };
  for (int i = 0; i < 12; ++i)
  {
    RelevoRaster raster;
    raster.Width = 1 + dice.Throw(4);
    raster.Height = 1 + dice.Throw(4);
    raster.Type = GDT_Byte;
    raster.SetValues([](int, int column, int row) { return column + row; });
    raster.CoordinateSystem = dice.Choose(systems);
    for (int j = 0; j < 6; ++j)
    {
      raster.Transform.push_back(
        dice.Once(3) ? std::pow(10.0, dice.Throw(600) - 300) : dice.Number());
    }
    const std::string name = folders.File("FuzzTerrainPlace" + std::to_string(i) + ".tif");
    if (raster.Write(name))
    {
      Files.push_back(name);
    }
  }
}

class Machine
{
public:
  explicit Machine(Dice& dice)
    : D(dice)
  {
    this->Vectors->SetInputConnection(this->Terrain->GetOutputPort());
    this->Vectors->SetTerrain(this->Terrain);
    this->Recipe->SetMaximumLevel(2);
    this->Recipe->SetDisplacement(this->Displacement);
    this->Displacement->SetHeightMap(this->Map);
    this->Refiner->SetRefinement(this->Recipe);
    this->Refiner->SetInputConnection(this->Terrain->GetOutputPort());
    this->Terrain->SetFileName(this->File());
  }

  std::vector<Call> GetCalls()
  {
    std::vector<Call> calls;
    this->AddMapCalls(calls);
    this->AddTerrainCalls(calls);
    this->AddVectorCalls(calls);
    for (int i = 0; i < 3; ++i)
    {
      calls.insert(calls.end(),
        { { "update map", [this] { this->Map->Update(); } },
          { "update terrain", [this] { this->Terrain->Update(); } },
          { "update vectors", [this] { this->Vectors->Update(); } },
          { "update refined", [this] { this->Refiner->Update(); } } });
    }
    return calls;
  }

  std::string FindError()
  {
    const double height = this->Map->GetHeight(this->D.Share(), this->D.Share());
    double range[2];
    this->Map->GetRange(range);
    const double slack = 1e-6 * (std::abs(range[0]) + std::abs(range[1]));
    if (!(range[0] <= range[1]) || !std::isfinite(height) ||
      (!this->Map->HasNoData() && !(height >= range[0] - slack && height <= range[1] + slack)))
    {
      return "heights are not in their range";
    }
    if (!RelevoFuzz::IsFinite(this->Terrain->GetOutput()) ||
      !RelevoFuzz::IsFinite(this->Refiner->GetOutput()))
    {
      return "a triangle has a point that is not finite";
    }
    return {};
  }

private:
  const char* File() { return this->D.Choose(Files).c_str(); }

  void AddMapCalls(std::vector<Call>& calls)
  {
    calls.insert(calls.end(),
      { { "file", [this] { this->Map->SetFileName(this->File()); } },
        { "image",
          [this] {
            this->Map->SetImageData(
              this->D.Once(2) ? nullptr : RelevoFuzz::MakeImage(this->D).Get());
          } },
        { "no data",
          [this]
          {
            this->D.Once(2) ? this->Map->UnsetNoDataValue()
                            : this->Map->SetNoDataValue(this->D.Number());
          } },
        { "size", [this] { this->Map->SetMaximumDimension(this->D.Whole()); } },
        { "ask the map",
          [this]
          {
            this->Map->UpdateInformation();
            this->Map->GetSample(this->D.Whole(), this->D.Whole());
            this->Map->GetHeight(this->D.Number(), this->D.Number());
            this->Map->IsValid(this->D.Number(), this->D.Number());
          } },
        { "displacement",
          [this]
          {
            this->Displacement->SetScale(this->D.Number());
            this->Displacement->SetOffset(this->D.Number());
            this->Displacement->SetNoDataPolicy(this->D.Whole());
            this->D.Once(2) ? this->Displacement->SetDirectionToNormal()
                            : this->Displacement->SetDirection(0.0, this->D.Number(), 1.0);
          } },
        { "terrain's displacement",
          [this]
          {
            this->Recipe->SetDisplacement(
              this->D.Once(2) ? this->Terrain->GetDisplacement() : this->Displacement.Get());
          } },
        { "print",
          [this]
          {
            std::ostringstream text;
            this->Map->Print(text);
            this->Terrain->Print(text);
            this->Vectors->Print(text);
          } } });
  }

  void AddTerrainCalls(std::vector<Call>& calls)
  {
    calls.insert(calls.end(),
      { { "terrain's file", [this] { this->Terrain->SetFileName(this->File()); } },
        { "imagery",
          [this]
          {
            this->Terrain->SetImageryFileName(this->D.Once(2) ? nullptr : this->File());
            this->Terrain->SetImageryBands(this->D.Whole(), this->D.Throw(4), this->D.Throw(4));
            this->Terrain->SetMaximumImagerySize(this->D.Once(2) ? 16 : this->D.Whole());
          } },
        { "no imagery", [this] { this->Terrain->SetImageryFileName(nullptr); } },
        { "resolution", [this] { this->Terrain->SetResolution(this->D.Throw(20) - 1); } },
        { "exaggeration", [this] { this->Terrain->SetExaggeration(this->D.Number()); } },
        { "terrain's no data",
          [this]
          {
            this->D.Once(2) ? this->Terrain->UnsetNoDataValue()
                            : this->Terrain->SetNoDataValue(this->D.Number());
            this->Terrain->SetNoDataPolicy(this->D.Whole());
            this->Terrain->SetMaximumDimension(this->D.Whole());
          } },
        { "ask the terrain",
          [this]
          {
            const double place[3] = { this->D.Number(), this->D.Number(), this->D.Number() };
            double result[3];
            this->Terrain->TerrainToMap(place, result);
            this->Terrain->MapToTerrain(place, result);
            this->Terrain->IsGeographic();
            this->Terrain->GetCoordinateSystem();
            this->Terrain->GetImagery();
          } } });
  }

  void AddVectorCalls(std::vector<Call>& calls)
  {
    calls.insert(calls.end(),
      { { "mesh", [this] { this->Vectors->SetInputData(RelevoFuzz::MakeMesh(this->D)); } },
        { "raster",
          [this]
          {
            this->Vectors->SetRasterData(
              this->D.Once(2) ? nullptr : RelevoFuzz::MakeImage(this->D).Get());
          } },
        { "array",
          [this]
          {
            this->Vectors->SetInputArrayToProcess(
              0, this->D.Throw(2), 0, this->D.Throw(3), RelevoFuzz::ChooseName(this->D).c_str());
            this->Vectors->SetOutputArrayName(RelevoFuzz::ChooseName(this->D).c_str());
          } },
        { "place",
          [this]
          {
            const std::vector<const char*> systems = { nullptr, "", "EPSG:4326", "EPSG:32633",
              "EPSG:3031", "EPSG:4978", "nonsense" };
            this->Vectors->SetCoordinateSystem(this->D.Choose(systems));
            this->Vectors->SetOrigin(this->D.Number(), this->D.Number(), 0.0);
            this->Vectors->SetExaggeration(this->D.Number());
            this->Vectors->SetTerrain(this->D.Once(2) ? nullptr : this->Terrain.Get());
          } },
        { "terrain's mesh",
          [this]
          {
            this->Vectors->SetInputConnection(this->Terrain->GetOutputPort());
            this->Refiner->SetInputConnection(this->Terrain->GetOutputPort());
          } },
        { "mesh to refine",
          [this] { this->Refiner->SetInputData(RelevoFuzz::MakeMesh(this->D)); } } });
  }

  Dice& D;
  vtkNew<vtkHeightMap> Map;
  vtkNew<vtkDisplacement> Displacement;
  vtkNew<vtkTerrainSource> Terrain;
  vtkNew<vtkGeographicVectors> Vectors;
  vtkNew<vtkAdaptiveRefinement> Recipe;
  vtkNew<vtkAdaptiveRefinementFilter> Refiner;
};
}

int TestFuzzTerrain(int argc, char* argv[])
{
  RelevoCheck check;
  const RelevoTestFolders folders(argc, argv);
  WriteFiles(folders);
  WritePlaces(folders);
  CHECK_GREATER(Files.size(), 20);
  int calls = 0;
  CHECK_EQUAL(RelevoFuzz::Run<Machine>(400, 40, calls), 0);
  std::cout << calls << " calls\n";
  return check.GetResult();
}
