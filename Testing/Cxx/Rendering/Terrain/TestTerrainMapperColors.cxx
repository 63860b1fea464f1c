// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Sea level, and lookup tables and titles of legends. The heights of the raster are known at each
// pixel of a view from above.
#include "RelevoPyramidScene.h"
#include "RelevoRasterFiles.h"

#include "vtkColorTransferFunction.h"
#include "vtkLookupTable.h"
#include "vtkProperty.h"
#include "vtkScalarBarActor.h"

#include <array>
#include <cmath>
#include <limits>

namespace
{
constexpr int Size = 400;        // of the raster and of the window
constexpr double Spacing = 30.0; // metres
constexpr double Rise = 0.25;    // metres per column

// The terrain rises from -50 to 49.75 metres.
double GetHeight(double column)
{
  return -50.0 + Rise * column;
}

class ColorScene : public RelevoPyramidScene
{
public:
  explicit ColorScene(const std::string& file)
    : RelevoPyramidScene(file, Size, Size)
  {
    this->Actor->GetProperty()->LightingOff();
    this->Mapper->SetColorModeToElevation();
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(0.0, 0.0, 20000.0);
    camera->SetFocalPoint(0.0, 0.0, 0.0);
    camera->SetViewUp(0.0, 1.0, 0.0);
    camera->ParallelProjectionOn();
    camera->SetParallelScale(0.5 * Size * Spacing);
    this->Renderer->ResetCameraClippingRange();
  }

  // Returns the middle row of the picture.
  std::vector<std::array<int, 3>> DrawRow()
  {
    const RelevoPicture picture = this->Draw();
    std::vector<std::array<int, 3>> row(Size);
    for (int x = 0; x < Size; ++x)
    {
      const unsigned char* pixel = &picture.Colors[3 * (static_cast<size_t>(Size / 2) * Size + x)];
      row[x] = { { pixel[0], pixel[1], pixel[2] } };
    }
    return row;
  }
};

std::string WriteRaster(RelevoCheck& check, const RelevoTestFolders& folders,
  const std::string& name, const std::string& unit = "", const std::string& system = "EPSG:32632")
{
  RelevoRaster raster = RelevoRaster::MakeMetric(Size, Size, Spacing);
  raster.CoordinateSystem = system;
  raster.Unit = unit;
  raster.SetValues([](int, int column, int) { return GetHeight(column); });
  const std::string file = folders.File(name);
  CHECK(raster.Write(file));
  return file;
}

vtkSmartPointer<vtkLookupTable> MakeRamp(bool isRed, double low, double high)
{
  auto table = vtkSmartPointer<vtkLookupTable>::New();
  table->SetNumberOfTableValues(64);
  for (int i = 0; i < 64; ++i)
  {
    const double value = 0.2 + 0.8 * i / 63.0;
    table->SetTableValue(i, isRed ? value : 0.0, isRed ? 0.0 : value, 0.0);
  }
  table->SetTableRange(low, high);
  return table;
}

// Pixels up to the sea level have the colours of water. The border is right to the pixel, and the
// colours are those of the two tables and of the legend.
void TestSeaLevel(RelevoCheck& check, const std::string& file)
{
  ColorScene scene(file);
  auto land = MakeRamp(true, 0.0, 50.0);
  auto water = MakeRamp(false, -50.0, 0.0);
  scene.Mapper->SetLookupTable(land);
  scene.Mapper->SetWaterLookupTable(water);
  const auto without = scene.DrawRow();
  CHECK(without[50][0] > 0 && without[50][1] == 0);
  scene.Mapper->UseSeaLevelOn();
  for (double seaLevel : { 0.0, -20.125, 13.25, -1000.0, 1000.0 })
  {
    CHECK_CASE(seaLevel);
    scene.Mapper->SetSeaLevel(seaLevel);
    const auto row = scene.DrawRow();
    vtkScalarsToColors* legend = scene.Mapper->GetLegendLookupTable();
    int wrong = 0;
    int different = 0;
    for (int x = 1; x < Size - 1; ++x)
    {
      const double height = GetHeight(x);
      const bool isWater = height <= seaLevel;
      wrong += (row[x][isWater ? 1 : 0] > 0 && row[x][isWater ? 0 : 1] == 0) ? 0 : 1;
      double expected[3];
      double inLegend[3];
      (isWater ? water : land)->GetColor(height, expected);
      legend->GetColor(height, inLegend);
      for (int c = 0; c < 3; ++c)
      {
        // An interval of a ramp is 3 of 255.
        different += std::abs(255.0 * expected[c] - row[x][c]) > 5.0 ? 1 : 0;
        different += std::abs(255.0 * inLegend[c] - row[x][c]) > 5.0 ? 1 : 0;
      }
    }
    // The height of a pixel that lies on the sea level has rounding errors.
    CHECK_LESS_EQUAL(wrong, 1);
    CHECK_LESS_EQUAL(different, 6);
  }
  scene.Mapper->UseSeaLevelOff();
  CHECK(scene.DrawRow() == without);
  RelevoErrors errors(scene.Mapper);
  scene.Mapper->SetSeaLevel(std::numeric_limits<double>::quiet_NaN());
  CHECK(errors.Said("SeaLevel"));
  CHECK_EQUAL(scene.Mapper->GetSeaLevel(), 1000.0);
}

// Plains at exactly the sea level are water.
void TestPlain(RelevoCheck& check, const RelevoTestFolders& folders)
{
  RelevoRaster raster = RelevoRaster::MakeMetric(64, 64, Spacing);
  for (double seaLevel : { 0.0, 137.37, -4321.1 })
  {
    CHECK_CASE(seaLevel);
    raster.SetValues(
      [seaLevel](int, int column, int row) {
        return column == 0 && row == 0 ? 8000.0 : column == 1 ? -9000.0 : seaLevel;
      });
    const std::string file = folders.File("TerrainMapperPlain.tif");
    CHECK(raster.Write(file));
    ColorScene scene(file);
    scene.Renderer->GetActiveCamera()->SetParallelScale(100.0);
    scene.Mapper->UseSeaLevelOn();
    scene.Mapper->SetSeaLevel(seaLevel);
    const auto row = scene.DrawRow();
    CHECK_GREATER(row[Size / 2][2], row[Size / 2][0] + 40); // blue
  }
}

// The default tables are blue below the sea level, and green to white above it.
void TestDefaultTables(
  RelevoCheck& check, const std::string& file, const RelevoTestFolders& folders)
{
  ColorScene scene(file);
  const auto before = scene.DrawRow();
  scene.Mapper->UseSeaLevelOn();
  scene.Draw().Save(folders.File("TerrainMapperSeaLevel.png"));
  const auto row = scene.DrawRow();
  CHECK(row[10][2] > row[10][0] + 40 && row[190][2] > row[190][0] + 40);
  CHECK_GREATER(row[190][1], row[10][1] + 100); // shallow and deep
  CHECK(row[210][1] > row[210][2] + 20);
  CHECK_GREATER(row[395][2], 200);
  // Other colours have no water.
  scene.Mapper->SetColorModeToSlope();
  const auto slopes = scene.DrawRow();
  scene.Mapper->UseSeaLevelOff();
  CHECK(scene.DrawRow() == slopes);
  scene.Mapper->SetColorModeToElevation();
  CHECK(scene.DrawRow() == before);
  // A copy draws the same.
  scene.Mapper->UseSeaLevelOn();
  scene.Mapper->SetSeaLevel(5.0);
  const auto expected = scene.DrawRow();
  vtkNew<vtkTerrainMapper> copy;
  copy->ShallowCopy(scene.Mapper);
  scene.Actor->SetMapper(copy);
  CHECK(scene.DrawRow() == expected);
  // Water can be translucent.
  CHECK(copy->HasOpaqueGeometry());
  auto water = MakeRamp(true, -50.0, 0.0);
  water->SetTableValue(3, 1.0, 0.0, 0.0, 0.5);
  copy->SetWaterLookupTable(water);
  CHECK(copy->HasTranslucentPolygonalGeometry());
}

void TestLegends(RelevoCheck& check, const std::string& file, const RelevoTestFolders& folders)
{
  {
    vtkNew<vtkTerrainMapper> empty;
    empty->SetColorModeToElevation();
    CHECK(empty->GetLegendLookupTable() == nullptr);
    CHECK_EQUAL(empty->GetLegendTitle(), "");
  }
  ColorScene scene(file); // before the first frame
  vtkTerrainMapper* mapper = scene.Mapper;
  CHECK_EQUAL(mapper->GetLegendTitle(), "Height [m]");
  CHECK(mapper->GetLegendLookupTable() == mapper->GetLookupTable());
  scene.Pyramid->WaitForIndex();
  CHECK_NEAR(mapper->GetLegendLookupTable()->GetRange()[1], GetHeight(Size - 1), 1e-3);
  mapper->SetColorModeToSlope();
  CHECK_EQUAL(mapper->GetLegendTitle(), "Slope [degrees]");
  CHECK_EQUAL(mapper->GetLegendLookupTable()->GetRange()[1], 90.0);
  mapper->SetColorModeToAspect();
  CHECK_EQUAL(mapper->GetLegendTitle(), "Aspect [degrees]");
  CHECK_EQUAL(mapper->GetLegendLookupTable()->GetRange()[1], 360.0);
  mapper->SetColorModeToHillshade();
  CHECK_EQUAL(mapper->GetLegendTitle(), "Hillshade");
  double grey[3];
  mapper->GetLegendLookupTable()->GetColor(0.5, grey);
  CHECK_NEAR(grey[1], 0.5, 0.01);
  CHECK_EQUAL(mapper->GetLegendLookupTable()->GetRange()[1], 1.0);
  mapper->SetColorModeToSolid();
  CHECK_EQUAL(mapper->GetLegendTitle(), "");
  CHECK(mapper->GetLegendLookupTable() == nullptr);
  // Another raster has its own range and unit.
  RelevoRaster other;
  other.Width = 20;
  other.Height = 20;
  other.Transform = { 500000.0, 600.0, 0.0, 4300000.0, 0.0, -600.0 };
  other.CoordinateSystem = "EPSG:32632";
  other.Unit = "kPa";
  other.SetValues([](int, int column, int) { return 3.0 + column; });
  const std::string name = folders.File("TerrainMapperPressure.tif");
  CHECK(other.Write(name));
  mapper->SetColorRasterFileName(name.c_str());
  CHECK_EQUAL(mapper->GetLegendTitle(), "Value [kPa]");
  CHECK_NEAR(mapper->GetLegendLookupTable()->GetRange()[0], 3.0, 1e-6);
  CHECK_NEAR(mapper->GetLegendLookupTable()->GetRange()[1], 22.0, 1e-6);
  // Units of heights.
  const std::array<std::array<std::string, 3>, 5> units = { { { "ft", "EPSG:32632", "ft" },
    { "metre", "", "m" }, { "K", "EPSG:32632", "K" }, { "", "EPSG:32632", "m" }, { "", "", "" } } };
  for (const auto& [unit, system, expected] : units)
  {
    CHECK_CASE(unit);
    vtkNew<vtkTerrainPyramid> pyramid;
    CHECK_EQUAL(std::string(pyramid->GetHeightUnit()), "");
    pyramid->SetFileName(
      WriteRaster(check, folders, "TerrainMapperUnit.tif", unit, system).c_str());
    CHECK(pyramid->Update());
    CHECK_EQUAL(std::string(pyramid->GetHeightUnit()), expected);
  }
}

// VTK's colour bar shows water and land.
void TestScalarBar(RelevoCheck& check, const std::string& file, const RelevoTestFolders& folders)
{
  ColorScene scene(file);
  scene.Mapper->UseSeaLevelOn();
  scene.Mapper->SetSeaLevel(10.0);
  scene.Actor->VisibilityOff();
  vtkNew<vtkScalarBarActor> bar;
  bar->SetLookupTable(scene.Mapper->GetLegendLookupTable());
  bar->SetTitle(scene.Mapper->GetLegendTitle().c_str());
  scene.Renderer->AddViewProp(bar);
  const RelevoPicture picture = scene.Draw();
  picture.Save(folders.File("TerrainMapperLegend.png"));
  size_t blue = 0;
  size_t green = 0;
  for (size_t i = 0; i < picture.GetNumberOfPixels(); ++i)
  {
    const unsigned char* pixel = &picture.Colors[3 * i];
    blue += pixel[2] > pixel[0] + 40 ? 1 : 0;
    green += pixel[1] > pixel[2] + 20 ? 1 : 0;
  }
  CHECK_GREATER(green, 100);
  // 60 % of the heights are water, most of the land is greener than blue.
  CHECK_GREATER(blue, green);
}
}

int TestTerrainMapperColors(int argc, char* argv[])
{
  RelevoCheck check;
  const RelevoTestFolders folders(argc, argv);
  const std::string file = WriteRaster(check, folders, "TerrainMapperRamp.tif");
  TestSeaLevel(check, file);
  TestPlain(check, folders);
  TestDefaultTables(check, file, folders);
  TestLegends(check, file, folders);
  TestScalarBar(check, file, folders);
  return check.GetResult();
}
