// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkTerrainMapper drapes imagery: the colours of pixels are those of their positions, within half
// a pixel of the imagery, within the limit of memory, and imagery that cannot be used is an error.
#include "RelevoPyramidScene.h"
#include "RelevoRasterFiles.h"

#include "vtkLookupTable.h"
#include "vtkProperty.h"
#include "vtkTerrainMapper.h"
#include "vtkTerrainPyramid.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iostream>

namespace
{
constexpr int Size = 700;

// Colours that change by 5 per pixel along a column or row.
constexpr int Period = 50;
double GetWave(double pixel)
{
  return 5.0 * std::abs(pixel - 2.0 * Period * std::floor(pixel / (2.0 * Period) + 0.5));
}

// 30 m between samples, in a UTM zone; hills in metres.
std::string WriteHills(const RelevoTestFolders& folders)
{
  RelevoRaster raster = RelevoRaster::MakeMetric(Size, Size, 30.0);
  raster.SetValues(
    [](int, int column, int row)
    {
      return 900.0 + 500.0 * std::sin(column / 60.0) * std::cos(row / 80.0) +
        120.0 * std::sin(column / 19.0 + row / 31.0);
    });
  const std::string file = folders.File("TerrainMapperImageryHills.tif");
  return raster.Write(file) ? file : "";
}

// A picture in degrees around the middle of the hills.
constexpr int PictureSize = 1200;
constexpr double Corner[2] = { 9.05, 38.82 };
constexpr double Degrees = 0.0001; // 8.7 m x 11.1 m

RelevoRaster MakePicture(int bands = 3)
{
  RelevoRaster raster;
  raster.Width = PictureSize;
  raster.Height = PictureSize;
  raster.NumberOfBands = bands;
  raster.Type = GDT_Byte;
  raster.Transform = { Corner[0], Degrees, 0.0, Corner[1], 0.0, -Degrees };
  raster.CoordinateSystem = "EPSG:4326";
  if (bands == 4)
  {
    raster.Options = { "PHOTOMETRIC=RGB", "ALPHA=YES" };
  }
  return raster;
}

std::string WritePicture(RelevoCheck& check, const RelevoRaster& raster,
  const RelevoTestFolders& folders, const std::string& name)
{
  const std::string file = folders.File(name);
  CHECK(raster.Write(file));
  return file;
}

class ImageryScene : public RelevoPyramidScene
{
public:
  explicit ImageryScene(const std::string& file, const std::string& imagery = "")
    : RelevoPyramidScene(file)
  {
    this->Mapper->SetImageryFileName(imagery.c_str());
    this->Look({ { -3000.0, -7000.0, 4000.0 } });
  }

  void Look(const std::array<double, 3>& from)
  {
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(from.data());
    camera->SetFocalPoint(0.0, 0.0, 500.0);
    camera->SetViewUp(0.0, 0.0, 1.0);
    this->Renderer->ResetCameraClippingRange();
  }
};

// The pixel of the picture that is drawn at a pixel of the window, from its depth.
std::array<double, 2> GetPicturePixel(
  RelevoCheck& check, ImageryScene& scene, double x, double y, double depth)
{
  scene.Renderer->SetDisplayPoint(x, y, depth);
  scene.Renderer->DisplayToWorld();
  double world[4];
  scene.Renderer->GetWorldPoint(world);
  double geographic[3];
  const double point[3] = { world[0] / world[3], world[1] / world[3], world[2] / world[3] };
  CHECK(scene.Mapper->WorldToGeographic(point, geographic));
  return { { (geographic[0] - Corner[0]) / Degrees - 0.5,
    (Corner[1] - geographic[1]) / Degrees - 0.5 } };
}

// Compares all pixels that the picture covers. Where a pixel of the window covers many pixels of
// the picture, or where the colours turn, the colour is a mean.
void TestPositions(RelevoCheck& check, const std::string& file, const RelevoTestFolders& folders)
{
  RelevoRaster raster = MakePicture();
  raster.SetValues(
    [](int band, int column, int row) {
      return band == 0 ? GetWave(column) : band == 1 ? GetWave(row) : 128.0;
    });
  const std::string imagery = WritePicture(check, raster, folders, "TerrainMapperImageryWaves.tif");
  ImageryScene scene(file, imagery);
  scene.Actor->GetProperty()->LightingOff();
  const std::array<std::array<double, 3>, 4> eyes = { { { { 300.0, -900.0, 2600.0 } },
    { { -1200.0, -900.0, 1900.0 } }, { { 0.0, -1.0, 2000.0 } }, { { 500.0, 700.0, 1800.0 } } } };
  for (std::size_t view = 0; view < eyes.size(); ++view)
  {
    CHECK_CASE(view);
    scene.Look(eyes[view]);
    const RelevoPicture picture = scene.Draw();
    picture.Save(folders.File("TerrainMapperImagery" + std::to_string(view) + ".png"));
    CHECK(scene.Mapper->IsComplete());
    int compared = 0;
    int different = 0;
    double largest = 0.0;
    for (int y = 1; y < 299; y += 5)
    {
      for (int x = 1; x < 399; x += 5)
      {
        const size_t pixel = static_cast<size_t>(y) * 400 + x;
        if (picture.Depths[pixel] >= 1.0f)
        {
          continue;
        }
        const auto here = GetPicturePixel(check, scene, x + 0.5, y + 0.5, picture.Depths[pixel]);
        const auto isNear = [&](int axis)
        {
          double footprint = 0.0;
          for (const int step : { 1, 400 })
          {
            const auto there = GetPicturePixel(check, scene, x + 0.5 + (step == 1 ? 1.0 : 0.0),
              y + 0.5 + (step == 1 ? 0.0 : 1.0), picture.Depths[pixel + step]);
            footprint += std::abs(there[axis] - here[axis]);
          }
          const double turn = std::abs(here[axis] - Period * std::floor(here[axis] / Period + 0.5));
          return footprint < 6.0 && turn > 8.0 && here[axis] > 8.0 &&
            here[axis] < PictureSize - 8.0;
        };
        for (int axis = 0; axis < 2; ++axis)
        {
          if (isNear(axis) && here[1 - axis] > 8.0 && here[1 - axis] < PictureSize - 8.0)
          {
            const double difference =
              std::abs(picture.Colors[3 * pixel + axis] - GetWave(here[axis])) / 5.0;
            largest = std::max(largest, difference);
            different += difference > 0.5 ? 1 : 0;
            ++compared;
          }
        }
      }
    }
    std::cout << "view " << view << ": " << compared << " compared, " << different
              << " more than half a pixel away, at most " << largest << "\n";
    CHECK_GREATER(compared, 5000);
    CHECK_EQUAL(different, 0);
  }
}

// A colour of the imagery looks like that colour of the actor. Where the imagery is transparent,
// the actor has its own colour.
void TestColors(RelevoCheck& check, const std::string& file, const RelevoTestFolders& folders)
{
  RelevoRaster raster = MakePicture(4);
  raster.Transform = { 8.9, 0.0005, 0.0, 38.95, 0.0, -0.0005 }; // all of the terrain
  raster.SetValues([](int band, int column, int)
    { return band == 3 ? (column < 530 ? 255.0 : 0.0) : 200.0 - 50.0 * band; });
  const std::string imagery = WritePicture(check, raster, folders, "TerrainMapperImageryAlpha.tif");
  ImageryScene scene(file);
  vtkProperty* property = scene.Actor->GetProperty();
  property->SetSpecular(0.4);
  property->SetAmbient(0.2);
  const auto setColor = [property](double red, double green, double blue)
  {
    property->SetColor(red, green, blue);
    property->SetSpecularColor(1.0, 1.0, 1.0);
  };
  setColor(0.1, 0.8, 0.3);
  const RelevoPicture own = scene.Draw();
  setColor(200.0 / 255.0, 150.0 / 255.0, 100.0 / 255.0);
  const RelevoPicture expected = scene.Draw();
  setColor(0.1, 0.8, 0.3);
  scene.Mapper->SetImageryFileName(imagery.c_str());
  CHECK_EQUAL(scene.Mapper->GetTerrainColorMode(), vtkTerrainMapper::COLOR_BY_IMAGERY);
  const RelevoPicture picture = scene.Draw();
  picture.Save(folders.File("TerrainMapperImageryAlpha.png"));
  int likeOwn = 0;
  int likeImagery = 0;
  int neither = 0;
  for (size_t i = 0; i < picture.GetNumberOfPixels(); ++i)
  {
    const auto isLike = [&](const RelevoPicture& other)
    {
      return std::abs(picture.Colors[3 * i] - other.Colors[3 * i]) <= 2 &&
        std::abs(picture.Colors[3 * i + 1] - other.Colors[3 * i + 1]) <= 2;
    };
    if (picture.Depths[i] < 1.0f)
    {
      likeOwn += isLike(own) ? 1 : 0;
      likeImagery += isLike(expected) ? 1 : 0;
      neither += isLike(own) || isLike(expected) ? 0 : 1;
    }
  }
  CHECK_GREATER(likeOwn, 10000);
  CHECK_GREATER(likeImagery, 10000);
  CHECK_LESS(neither, 2000); // along the border
  CHECK(picture.Depths == own.Depths);
  // Without imagery again.
  scene.Mapper->SetImageryFileName(nullptr);
  CHECK(scene.Mapper->GetImageryFileName() == nullptr);
  CHECK(scene.Draw().Colors == own.Colors);
}

// The values of another raster through the lookup table, and other bands of imagery.
void TestRaster(RelevoCheck& check, const std::string& file, const RelevoTestFolders& folders)
{
  RelevoRaster raster = MakePicture(1);
  raster.Type = GDT_Float32;
  raster.NoData = -5.0;
  raster.SetValues(
    [](int, int column, int row) { return row < 500 ? -5.0 : column / (PictureSize - 1.0); });
  const std::string values = WritePicture(check, raster, folders, "TerrainMapperImageryValues.tif");
  ImageryScene scene(file);
  scene.Actor->GetProperty()->LightingOff();
  scene.Look({ { 0.0, -1.0, 24000.0 } });
  scene.Mapper->SetColorRasterFileName(values.c_str());
  CHECK_EQUAL(scene.Mapper->GetTerrainColorMode(), vtkTerrainMapper::COLOR_BY_RASTER);
  const RelevoPicture first = scene.Draw();
  first.Save(folders.File("TerrainMapperImageryValues.png"));
  const double* range = scene.Mapper->GetLookupTable()->GetRange();
  CHECK_NEAR(range[0], 0.0, 0.02);
  CHECK_NEAR(range[1], 1.0, 0.02);
  vtkNew<vtkLookupTable> table;
  table->SetNumberOfTableValues(256);
  table->SetHueRange(0.0, 0.0);
  table->SetSaturationRange(0.0, 0.0);
  table->SetValueRange(0.0, 1.0);
  table->SetRampToLinear();
  table->SetNanColor(1.0, 0.0, 0.0, 1.0);
  table->Build();
  scene.Mapper->SetLookupTable(table);
  const RelevoPicture picture = scene.Draw();
  picture.Save(folders.File("TerrainMapperImageryGrey.png"));
  int missing = 0;
  int present = 0;
  for (int y = 5; y < 300; y += 10)
  {
    for (int x = 5; x < 400; x += 10)
    {
      const size_t pixel = static_cast<size_t>(y) * 400 + x;
      const unsigned char* color = &picture.Colors[3 * pixel];
      const auto here = GetPicturePixel(check, scene, x + 0.5, y + 0.5, picture.Depths[pixel]);
      const double last = PictureSize - 1.0;
      if (here[0] < -20.0 || here[0] > last + 20.0 || here[1] < 480.0 || here[1] > last + 20.0)
      {
        CHECK(color[0] == 255 && color[1] == 0 && color[2] == 0);
        ++missing;
      }
      else if (here[0] > 20.0 && here[0] < last - 20.0 && here[1] > 520.0 && here[1] < last - 20.0)
      {
        CHECK_LESS_EQUAL(std::abs(color[1] - 255.0 * here[0] / last), 2.0);
        ++present;
      }
    }
  }
  CHECK_GREATER(missing, 100);
  CHECK_GREATER(present, 100);

  RelevoErrors errors(scene.Mapper);
  scene.Mapper->SetImageryFileName(folders.File("TerrainMapperImageryWaves.tif").c_str());
  const RelevoPicture waves = scene.Draw();
  scene.Mapper->SetImageryBands(2, 1, 3);
  const RelevoPicture exchanged = scene.Draw();
  for (size_t i = 0; i < waves.Colors.size(); i += 3)
  {
    if (waves.Colors[i] != exchanged.Colors[i + 1] || waves.Colors[i + 1] != exchanged.Colors[i])
    {
      // Only where there is no imagery, the colours stay.
      CHECK(waves.Colors[i] == exchanged.Colors[i] && waves.Colors[i + 1] == waves.Colors[i + 2]);
    }
  }
  CHECK(waves.Colors != exchanged.Colors);
  CHECK(errors.None());
  scene.Mapper->SetImageryBands(1, 2, 0);
  CHECK(errors.Said("ImageryBands must be three bands"));
  scene.Mapper->SetImageryBands(1, 2, 7);
  scene.Draw();
  CHECK(errors.Said("it has no band 7"));
}

// Imagery that is read in the background ends with the picture of complete loading.
void TestBackground(RelevoCheck& check, const std::string& file, const RelevoTestFolders& folders)
{
  const std::string imagery = folders.File("TerrainMapperImageryWaves.tif");
  ImageryScene scene(file, imagery);
  const RelevoPicture expected = scene.Draw();
  CHECK(scene.Mapper->IsComplete());
  ImageryScene other(file, imagery);
  other.Mapper->SetLoadingModeToBackground();
  int frames = 0;
  do
  {
    other.Window->Render();
    ++frames;
  } while (!other.Mapper->IsComplete() && frames < 100000);
  CHECK_GREATER(frames, 1);
  CHECK(other.Draw().Colors == expected.Colors);
  vtkNew<vtkTerrainMapper> copy;
  copy->ShallowCopy(scene.Mapper);
  scene.Actor->SetMapper(copy);
  CHECK(scene.Draw().Colors == expected.Colors);
  scene.Actor->SetMapper(scene.Mapper);
}

// Heights, imagery and textures together stay within the limit.
void TestMemoryLimit(RelevoCheck& check, const std::string& file, const RelevoTestFolders& folders)
{
  const std::string imagery = folders.File("TerrainMapperImageryWaves.tif");
  for (const vtkTypeInt64 limit : { vtkTypeInt64(1) << 22, vtkTypeInt64(1) << 24 })
  {
    CHECK_CASE(limit);
    ImageryScene scene(file, imagery);
    RelevoErrors errors(scene.Mapper);
    scene.Mapper->SetMemoryLimit(limit);
    scene.Mapper->SetScreenSpaceError(0.3);
    for (int i = 0; i < 12; ++i)
    {
      CHECK_CASE(i);
      scene.Mapper->SetLoadingMode((i + 1) % 2);
      const double angle = 0.5 * i;
      scene.Look({ { 2000.0 * std::cos(angle), 2000.0 * std::sin(angle), 1500.0 + 200.0 * i } });
      const RelevoPicture picture = scene.Draw();
      CHECK_GREATER(picture.CountForeground(), 30000);
      CHECK_LESS_EQUAL(scene.Mapper->GetResidentMemorySize(), limit);
      // Imagery is drawn, if coarser.
      int colorful = 0;
      for (size_t pixel = 0; pixel < picture.Colors.size(); pixel += 3)
      {
        colorful += std::abs(picture.Colors[pixel] - picture.Colors[pixel + 1]) > 10 ? 1 : 0;
      }
      CHECK_GREATER(colorful, 10000);
    }
    CHECK(errors.None());
    CHECK(!scene.Mapper->IsComplete());
  }
}

void TestErrors(RelevoCheck& check, const std::string& file, const RelevoTestFolders& folders)
{
  ImageryScene scene(file);
  const RelevoPicture own = scene.Draw();
  RelevoErrors errors(scene.Mapper);
  const auto fails = [&](const std::string& imagery, const std::string& reason)
  {
    scene.Mapper->SetImageryFileName(imagery.c_str());
    CHECK(scene.Draw().Colors == own.Colors);
    CHECK(errors.Said(reason));
    CHECK(scene.Draw().Colors == own.Colors);
    CHECK(errors.None()); // once
    CHECK(scene.Mapper->IsComplete());
  };
  fails(folders.File("no picture.tif"), "no picture.tif: the file does not exist");
  const std::string text = folders.File("TerrainMapperImageryText.png");
  std::ofstream(text) << "no picture";
  fails(text, "TerrainMapperImageryText.png");
  RelevoRaster raster = MakePicture();
  raster.Width = 20;
  raster.Height = 20;
  raster.SetValues([](int, int, int) { return 200.0; });
  raster.Transform[0] = 12.0;
  fails(WritePicture(check, raster, folders, "TerrainMapperImageryElsewhere.tif"),
    "does not overlap the terrain");
  RelevoTruncate(folders.File("TerrainMapperImageryWaves.tif"),
    folders.File("TerrainMapperImageryHalf.tif"), 0.5);
  fails(folders.File("TerrainMapperImageryHalf.tif"), "truncated");

  // Without a georeference, the picture covers the terrain.
  raster.Transform.clear();
  raster.CoordinateSystem.clear();
  scene.Mapper->SetImageryFileName(
    WritePicture(check, raster, folders, "TerrainMapperImageryPlain.tif").c_str());
  const RelevoPicture picture = scene.Draw();
  CHECK(errors.Warned("no georeference"));
  CHECK(errors.None());
  CHECK(picture.Colors != own.Colors);
  CHECK(picture.Depths == own.Depths);
  scene.Draw();
  CHECK(errors.None()); // once
}
}

int TestTerrainMapperImagery(int argc, char* argv[])
{
  const RelevoTestFolders folders(argc, argv);
  RelevoCheck check;
  const std::string file = WriteHills(folders);
  CHECK(!file.empty());
  TestPositions(check, file, folders);
  TestColors(check, file, folders);
  TestRaster(check, file, folders);
  TestBackground(check, file, folders);
  TestMemoryLimit(check, file, folders);
  TestErrors(check, file, folders);
  return check.GetResult();
}
