// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkTerrainMapper draws rasters in the geocentric frame: a closed globe without holes, the same
// for longitudes from -180 and from 0, a projected raster, and a moon.
#include "RelevoPyramidScene.h"
#include "RelevoRasterFiles.h"

#include "vtkLookupTable.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkProperty.h"
#include "vtkTerrainMapper.h"
#include "vtkTerrainPyramid.h"
#include "vtkWorldPointPicker.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib> // for setenv
#include <filesystem>
#include <fstream>

namespace
{
constexpr double EarthAxis = 6378137.0;
constexpr double EarthFlattening = 1.0 / 298.257223563;
constexpr double MoonRadius = 1737400.0;
constexpr int WindowSize = 300;

using Point = std::array<double, 3>;

double GetRelief(double longitude, double latitude)
{
  const double x = std::cos(latitude) * std::cos(longitude);
  const double y = std::cos(latitude) * std::sin(longitude);
  const double z = std::sin(latitude);
  double sum = 0.0;
  double size = 3000.0;
  for (double wave = 2.5; wave < 90.0; wave *= 1.9)
  {
    sum += size * std::sin(wave * x + std::cos(wave * y)) * std::cos(0.8 * wave * z);
    size *= 0.6;
  }
  return sum;
}

RelevoRaster MakeGlobe(int width, int height, double left, double top, double step)
{
  RelevoRaster raster;
  raster.Width = width;
  raster.Height = height;
  raster.Type = GDT_Float32;
  raster.Transform = { left, step, 0.0, top, 0.0, -step };
  raster.CoordinateSystem = "EPSG:4326";
  raster.SetValues(
    [=](int, int column, int row)
    {
      return GetRelief(vtkMath::RadiansFromDegrees(left + (column + 0.5) * step),
        vtkMath::RadiansFromDegrees(top - (row + 0.5) * step));
    });
  return raster;
}

class GlobeScene : public RelevoPyramidScene
{
public:
  GlobeScene(const RelevoRaster& raster, const std::string& file)
    : RelevoPyramidScene(file, WindowSize, WindowSize)
  {
    raster.Write(file);
    std::filesystem::remove(file + ".relevo-index");
    this->Mapper->SetFrameToGeocentric();
  }

  RelevoPicture Draw()
  {
    this->Renderer->ResetCameraClippingRange();
    this->Window->Render();
    return RelevoPicture(this->Window);
  }

  vtkCamera* GetCamera() { return this->Renderer->GetActiveCamera(); }

  // Looks at the earth's centre from a place.
  void LookDown(double longitude, double latitude, double height)
  {
    const double geographic[3] = { longitude, latitude, height };
    double eye[3];
    this->Mapper->GeographicToWorld(geographic, eye);
    vtkCamera* camera = this->GetCamera();
    camera->SetPosition(eye);
    camera->SetFocalPoint(0.0, 0.0, 0.0);
    camera->SetViewUp(
      std::abs(latitude) > 80.0 ? 1.0 : 0.0, 0.0, std::abs(latitude) > 80.0 ? 0.0 : 1.0);
  }

  // Looks from a place to another one, with the horizon upright.
  void LookTo(const Point& from, const Point& to)
  {
    Point eye;
    Point focus;
    this->Mapper->GeographicToWorld(from.data(), eye.data());
    this->Mapper->GeographicToWorld(to.data(), focus.data());
    vtkCamera* camera = this->GetCamera();
    camera->SetPosition(eye.data());
    camera->SetFocalPoint(focus.data());
    camera->SetViewUp(eye.data());
  }

  // The number of background pixels that are inside of the ellipsoid's silhouette.
  int CountHoles(const RelevoPicture& picture, double axis, double flattening)
  {
    vtkNew<vtkMatrix4x4> toWorld;
    toWorld->DeepCopy(this->GetCamera()->GetCompositeProjectionTransformMatrix(1.0, -1.0, 1.0));
    toWorld->Invert();
    const double* eye = this->GetCamera()->GetPosition();
    const double ratio = 1.0 / (1.0 - flattening);
    int holes = 0;
    for (int y = 0; y < WindowSize; ++y)
    {
      for (int x = 0; x < WindowSize; ++x)
      {
        double target[4] = { 2.0 * (x + 0.5) / WindowSize - 1.0, 2.0 * (y + 0.5) / WindowSize - 1.0,
          0.5, 1.0 };
        toWorld->MultiplyPoint(target, target);
        double from[3];
        double along[3];
        for (int i = 0; i < 3; ++i)
        {
          const double scale = i == 2 ? ratio : 1.0;
          from[i] = eye[i] * scale;
          along[i] = (target[i] / target[3] - eye[i]) * scale;
        }
        const double closest = -vtkMath::Dot(from, along) / vtkMath::Dot(along, along);
        double nearest[3];
        for (int i = 0; i < 3; ++i)
        {
          nearest[i] = from[i] + closest * along[i];
        }
        // The terrain is up to 8 km below the ellipsoid, and drawn within a pixel.
        const double pixel = closest * vtkMath::Norm(along) * 2.0 *
          std::tan(vtkMath::RadiansFromDegrees(0.5 * this->GetCamera()->GetViewAngle())) /
          WindowSize;
        if (closest > 0.0 && vtkMath::Norm(nearest) < axis - 8000.0 - 1.5 * pixel &&
          picture.Depths[y * WindowSize + x] >= 1.0f)
        {
          ++holes;
        }
      }
    }
    return holes;
  }
};

void TestHoles(RelevoCheck& check, const RelevoTestFolders& folders, const RelevoRaster& raster,
  const std::string& name)
{
  GlobeScene scene(raster, folders.File(name + ".tif"));
  const double places[][2] = { { 0.0, 10.0 }, { 180.0, 0.0 }, { -179.9, 40.0 }, { 60.0, 90.0 },
    { 17.0, -90.0 }, { 179.0, 89.0 }, { 0.0, -88.0 }, { -90.0, -30.0 } };
  for (const double height : { 2.5e7, 1e6, 1e5 })
  {
    for (const double(&place)[2] : places)
    {
      CHECK_CASE(name + " from " + std::to_string(place[0]) + " " + std::to_string(place[1]) + " " +
        std::to_string(height));
      scene.LookDown(place[0], place[1], height);
      const RelevoPicture picture = scene.Draw();
      CHECK_EQUAL(scene.CountHoles(picture, EarthAxis, EarthFlattening), 0);
      CHECK_LESS_EQUAL(scene.Mapper->GetScreenSpaceErrorInUse(), 1.0 + 1e-6);
    }
  }
  // Along the antimeridian and over a pole.
  const std::array<Point, 2> lines[3] = {
    { { { { 180.0, 20.0, 60000.0 } }, { { 180.0, 21.0, 0.0 } } } },
    { { { { 30.0, 88.0, 60000.0 } }, { { 30.0, 90.0, 0.0 } } } },
    { { { { 30.0, -88.0, 60000.0 } }, { { 30.0, -90.0, 0.0 } } } }
  };
  for (const std::array<Point, 2>& line : lines)
  {
    CHECK_CASE(line[0][1]);
    scene.LookTo(line[0], line[1]);
    const RelevoPicture picture = scene.Draw();
    picture.Save(folders.File(name + ".png"));
    CHECK_EQUAL(scene.CountHoles(picture, EarthAxis, EarthFlattening), 0);
  }
}

// The number of pixels of the terrain that are much darker than those beside, above and below them.
int CountDarkPixels(const RelevoPicture& picture, int size)
{
  int dark = 0;
  for (int y = 1; y < size - 1; ++y)
  {
    for (int x = 1; x < size - 1; ++x)
    {
      const int pixel = y * size + x;
      int darkest = 255;
      bool isTerrain = picture.Depths[pixel] < 1.0f;
      for (const int neighbor : { pixel - 1, pixel + 1, pixel - size, pixel + size })
      {
        darkest = std::min<int>(darkest, picture.Colors[3 * neighbor]);
        isTerrain = isTerrain && picture.Depths[neighbor] < 1.0f;
      }
      dark += isTerrain && picture.Colors[3 * pixel] < darkest - 25 ? 1 : 0;
    }
  }
  return dark;
}

// Triangles at a pole are slivers, and the derivatives of longitudes are infinite.
void TestPoles(RelevoCheck& check, const RelevoTestFolders& folders)
{
  constexpr int size = 600;
  GlobeScene scene(MakeGlobe(720, 361, -180.25, 90.25, 0.5), folders.File("GlobePoles.tif"));
  scene.Window->SetSize(size, size);
  const std::array<double, 2> distances[] = { { { 0.5, 20000.0 } }, { { 2.0, 60000.0 } },
    { { 4.0, 150000.0 } }, { { 20.0, 1e6 } } };
  for (const double pole : { 90.0, -90.0 })
  {
    for (const double longitude : { 0.0, 77.0 })
    {
      for (const auto& [degrees, height] : distances)
      {
        CHECK_CASE(std::to_string(pole) + " from " + std::to_string(longitude) + " at " +
          std::to_string(height));
        const double latitude = pole > 0.0 ? pole - degrees : pole + degrees;
        scene.LookTo({ { longitude, latitude, height } }, { { longitude, pole, 0.0 } });
        for (const bool isHillshade : { false, true })
        {
          scene.Mapper->SetTerrainColorMode(
            isHillshade ? vtkTerrainMapper::COLOR_BY_HILLSHADE : vtkTerrainMapper::COLOR_SOLID);
          const RelevoPicture picture = scene.Draw();
          picture.Save(folders.File("GlobePole.png"));
          CHECK_EQUAL(CountDarkPixels(picture, size), 0);
        }
      }
    }
  }
}

// The number of pixels whose colours differ visibly.
int CountDifferent(const RelevoPicture& a, const RelevoPicture& b)
{
  int different = 0;
  for (std::size_t i = 0; i < a.GetNumberOfPixels(); ++i)
  {
    int largest = 0;
    for (int c = 0; c < 3; ++c)
    {
      largest = std::max(largest, std::abs(a.Colors[3 * i + c] - b.Colors[3 * i + c]));
    }
    different += largest > 24 ? 1 : 0;
  }
  return different;
}

void TestLongitudes(RelevoCheck& check, const RelevoTestFolders& folders)
{
  GlobeScene west(MakeGlobe(720, 360, -180.0, 90.0, 0.5), folders.File("GlobeWest.tif"));
  GlobeScene east(MakeGlobe(720, 360, 0.0, 90.0, 0.5), folders.File("GlobeEast.tif"));
  for (GlobeScene* scene : { &west, &east })
  {
    vtkNew<vtkLookupTable> table;
    table->SetHueRange(0.667, 0.0);
    table->SetTableRange(-7000.0, 7000.0);
    scene->Mapper->SetLookupTable(table);
    scene->Mapper->SetColorModeToElevation();
    scene->Mapper->SetScreenSpaceError(0.25);
  }
  for (const double longitude : { 0.0, 90.0, 180.0, -90.0 })
  {
    CHECK_CASE(longitude);
    west.LookDown(longitude, 25.0, 9e6);
    east.LookDown(longitude, 25.0, 9e6);
    const RelevoPicture first = west.Draw();
    const RelevoPicture second = east.Draw();
    first.Save(folders.File("GlobeWest.png"));
    second.Save(folders.File("GlobeEast.png"));
    CHECK_LESS(CountDifferent(first, second), WindowSize * WindowSize / 200);
  }
}

// Blue and green imagery whose longitudes start at `left`.
RelevoRaster MakeImagery(double left)
{
  RelevoRaster raster;
  raster.Width = 720;
  raster.Height = 360;
  raster.NumberOfBands = 3;
  raster.Type = GDT_Byte;
  raster.Transform = { left, 0.5, 0.0, 90.0, 0.0, -0.5 };
  raster.CoordinateSystem = "EPSG:4326";
  raster.SetValues(
    [left](int band, int column, int row)
    {
      const double longitude = vtkMath::RadiansFromDegrees(left + (column + 0.5) * 0.5);
      return band == 0 ? 0.0
        : band == 1    ? 128.0 + 100.0 * std::sin(longitude)
                       : 128.0 + 100.0 * std::sin(5.0 * longitude) * std::sin(row / 20.0);
    });
  return raster;
}

// Imagery from 0 to 360 degrees covers a raster from -180 to 180, and the reverse, on a globe and
// on a map. The actor is red where it does not.
void TestImagery(RelevoCheck& check, const RelevoTestFolders& folders)
{
  const std::string western = folders.File("GlobeImageryWest.tif");
  const std::string eastern = folders.File("GlobeImageryEast.tif");
  CHECK(MakeImagery(-180.0).Write(western));
  CHECK(MakeImagery(0.0).Write(eastern));
  for (const double left : { -180.0, 0.0 })
  {
    GlobeScene scene(MakeGlobe(720, 360, left, 90.0, 0.5), folders.File("GlobeImagery.tif"));
    scene.Actor->GetProperty()->SetColor(1.0, 0.0, 0.0);
    scene.Actor->GetProperty()->LightingOff();
    const auto compare = [&](const std::string& name)
    {
      CHECK_CASE(name + " from " + std::to_string(left));
      scene.Mapper->SetImageryFileName(western.c_str());
      const RelevoPicture first = scene.Draw();
      scene.Mapper->SetImageryFileName(eastern.c_str());
      const RelevoPicture second = scene.Draw();
      second.Save(folders.File("GlobeImagery" + name + ".png"));
      CHECK_LESS(CountDifferent(first, second), WindowSize * WindowSize / 1000);
      for (const RelevoPicture* picture : { &first, &second })
      {
        int red = 0;
        for (std::size_t i = 0; i < picture->GetNumberOfPixels(); ++i)
        {
          red += picture->Depths[i] < 1.0f && picture->Colors[3 * i] > 24 ? 1 : 0;
        }
        CHECK_EQUAL(red, 0);
      }
    };
    for (const double longitude : { 0.0, 90.0, 180.0, -90.0 })
    {
      scene.LookDown(longitude, 25.0, 9e6);
      compare("At" + std::to_string(static_cast<int>(longitude)));
    }
    scene.LookDown(180.0, 5.0, 1e5); // a pixel is less than a sample
    compare("Near");
    scene.Mapper->SetFrameToMap();
    scene.Renderer->ResetCamera();
    scene.GetCamera()->SetPosition(0.0, 0.0, 5e7);
    scene.GetCamera()->SetFocalPoint(0.0, 0.0, 0.0);
    scene.GetCamera()->SetViewUp(0.0, 1.0, 0.0);
    compare("Map");
  }
}

// A translucent globe has one layer at the seam, except for single pixels.
void TestTranslucency(RelevoCheck& check, const RelevoTestFolders& folders)
{
  GlobeScene scene(MakeGlobe(720, 360, -180.0, 90.0, 0.5), folders.File("GlobeTranslucent.tif"));
  scene.Renderer->SetBackground(1.0, 1.0, 1.0);
  scene.Window->SetAlphaBitPlanes(1);
  vtkProperty* property = scene.Actor->GetProperty();
  property->SetOpacity(0.5);
  property->SetColor(1.0, 0.3, 0.1);
  property->LightingOff();
  property->BackfaceCullingOn();
  constexpr int once = 166; // green of the actor over white
  for (const bool isPeeled : { false, true })
  {
    scene.Renderer->SetUseDepthPeeling(isPeeled);
    for (const Point& place : { Point{ { 180.0, 15.0, 1e6 } }, Point{ { 180.0, 15.0, 1e5 } },
           Point{ { 179.9, 40.0, 3e5 } }, Point{ { -179.9, -60.0, 5e4 } } })
    {
      CHECK_CASE(place[2]);
      scene.LookDown(place[0], place[1], place[2]);
      const RelevoPicture picture = scene.Draw();
      picture.Save(folders.File("GlobeTranslucent.png"));
      int others = 0;
      for (std::size_t i = 0; i < picture.GetNumberOfPixels(); ++i)
      {
        others += std::abs(picture.Colors[3 * i + 1] - once) > 2 ? 1 : 0;
      }
      std::cout << others << " pixels without or with two layers\n";
      CHECK_LESS(others, WindowSize / 5);
    }
  }
}

// The limit of memory includes the positions of vertices. If the faces do not fit, the error grows.
void TestMemory(RelevoCheck& check, const RelevoTestFolders& folders)
{
  GlobeScene scene(MakeGlobe(720, 360, -180.0, 90.0, 0.5), folders.File("GlobeMemory.tif"));
  constexpr vtkTypeInt64 small = 16 << 20;
  const auto draw = [&](vtkTypeInt64 limit, double height)
  {
    scene.Mapper->SetMemoryLimit(limit);
    scene.LookDown(10.0, 40.0, height);
    const RelevoPicture picture = scene.Draw();
    CHECK_LESS_EQUAL(scene.Mapper->GetResidentMemorySize(), limit);
    CHECK_EQUAL(scene.CountHoles(picture, EarthAxis, EarthFlattening), 0);
  };
  scene.Mapper->SetScreenSpaceError(0.01);
  draw(vtkTypeInt64(1) << 29, 9e6);
  CHECK(scene.Mapper->IsComplete());
  const vtkIdType needed = scene.Mapper->GetNumberOfDrawnTriangles();
  draw(small, 9e6);
  const vtkIdType drawn = scene.Mapper->GetNumberOfDrawnTriangles();
  std::cout << drawn << " of " << needed << " triangles, error "
            << scene.Mapper->GetScreenSpaceErrorInUse() << " pixels, "
            << scene.Mapper->GetResidentMemorySize() << " bytes\n";
  CHECK(!scene.Mapper->IsComplete());
  CHECK_GREATER(scene.Mapper->GetScreenSpaceErrorInUse(), 0.01);
  CHECK_LESS(drawn, needed);
  // A quarter of the limit, 64 triangles per face.
  CHECK_LESS_EQUAL(drawn, 64 * small / 4 / 5000);
  CHECK_GREATER(drawn, 64 * small / 4 / 20000);
  // Far away, few faces suffice.
  draw(small, 2e9);
  CHECK(scene.Mapper->IsComplete());
  CHECK_LESS_EQUAL(scene.Mapper->GetScreenSpaceErrorInUse(), 0.01);
}

// A projected raster: the place and the height of a pixel, from its depth.
void TestProjected(RelevoCheck& check, const RelevoTestFolders& folders)
{
  RelevoRaster raster;
  raster.Width = 401;
  raster.Height = 301;
  raster.Type = GDT_Float32;
  raster.Transform = { 450000.0, 100.0, 0.0, 5300000.0, 0.0, -100.0 };
  raster.CoordinateSystem = "EPSG:32633";
  raster.SetValues([](int, int column, int row)
    { return 800.0 + 300.0 * std::sin(column / 20.0) * std::cos(row / 25.0); });
  GlobeScene scene(raster, folders.File("GlobeProjected.tif"));
  CHECK(scene.Pyramid->Update() && scene.Pyramid->WaitForIndex());
  const double coordinates[2] = { 469000.0, 5286000.0 };
  double geographic[3] = { 0.0, 0.0, 20000.0 };
  CHECK(scene.Pyramid->RasterToGeographic(coordinates, geographic));
  const Point under = { { geographic[0], geographic[1], 0.0 } };
  scene.LookTo({ { geographic[0], geographic[1] - 0.1, 9000.0 } }, under);
  const RelevoPicture picture = scene.Draw();
  picture.Save(folders.File("GlobeProjected.png"));
  CHECK_GREATER(picture.CountForeground(), picture.GetNumberOfPixels() / 2);
  vtkNew<vtkWorldPointPicker> picker;
  double world[3];
  for (const int x : { 100, 150, 200 })
  {
    picker->Pick(x, 100.0, 0.0, scene.Renderer);
    picker->GetPickPosition(world);
    CHECK(scene.Mapper->WorldToGeographic(world, geographic));
    double picked[2];
    CHECK(scene.Pyramid->GeographicToRaster(geographic, picked));
    CHECK_NEAR(geographic[2], scene.Pyramid->GetElevation(picked[0], picked[1]), 30.0);
    double back[3];
    CHECK(scene.Mapper->GeographicToWorld(geographic, back));
    CHECK_LESS(vtkMath::Distance2BetweenPoints(world, back), 1e-6);
    double raster[3];
    CHECK(scene.Mapper->WorldToRaster(world, raster));
    CHECK_NEAR(raster[0], picked[0], 1e-6);
    CHECK_NEAR(raster[2] * scene.Pyramid->GetVerticalUnit(), geographic[2], 1e-6);
    CHECK(scene.Mapper->RasterToWorld(raster, back));
    CHECK_LESS(vtkMath::Distance2BetweenPoints(world, back), 1e-6);
  }
  // Bounds are tight: the raster is 40 km x 30 km, and 600 m high.
  const double* bounds = scene.Mapper->GetBounds();
  for (int axis = 0; axis < 3; ++axis)
  {
    CHECK_LESS(bounds[2 * axis + 1] - bounds[2 * axis], 50000.0);
    CHECK_LESS(bounds[2 * axis], world[axis]);
    CHECK_LESS(world[axis], bounds[2 * axis + 1]);
  }
  // The map is another frame of the same mapper.
  scene.Mapper->SetFrameToMap();
  CHECK_NEAR(scene.Mapper->GetBounds()[0], -20000.0, 1e-6);
  scene.Mapper->SetFrameToGeocentric();
  CHECK_GREATER(scene.Mapper->GetBounds()[5], 4e6);
}

void TestMoon(RelevoCheck& check, const RelevoTestFolders& folders)
{
  RelevoRaster raster = MakeGlobe(360, 180, -180.0, 90.0, 1.0);
  raster.CoordinateSystem =
    "GEOGCS[\"Moon\",DATUM[\"Moon\",SPHEROID[\"Moon\",1737400,0]],PRIMEM[\"Reference "
    "Meridian\",0],UNIT[\"degree\",0.0174532925199433]]";
  GlobeScene scene(raster, folders.File("GlobeMoon.tif"));
  scene.LookDown(20.0, 10.0, 6e6);
  scene.Mapper->SetColorModeToHillshade();
  const RelevoPicture picture = scene.Draw();
  picture.Save(folders.File("GlobeMoon.png"));
  CHECK_EQUAL(scene.CountHoles(picture, MoonRadius, 0.0), 0);
  const double* bounds = scene.Mapper->GetBounds();
  for (int axis = 0; axis < 3; ++axis)
  {
    CHECK_NEAR(bounds[2 * axis], -MoonRadius, 25000.0);
    CHECK_NEAR(bounds[2 * axis + 1], MoonRadius, 25000.0);
  }
}

// Writes a geoid that is 40 m above the ellipsoid everywhere, in GeographicLib's format.
void WriteGeoid(const std::string& folder)
{
  std::filesystem::create_directories(folder);
  std::ofstream file(folder + "/egm96-5.pgm", std::ios::binary);
  file << "P5\n# Offset -108\n# Scale 0.003\n36 19\n65535\n";
  constexpr int pixel = 49333; // (40 + 108) / 0.003
  for (int i = 0; i < 36 * 19; ++i)
  {
    file.put(static_cast<char>(pixel >> 8));
    file.put(static_cast<char>(pixel & 255));
  }
}

void TestGeoid(RelevoCheck& check, const RelevoTestFolders& folders)
{
  RelevoRaster raster = MakeGlobe(40, 40, 0.0, 10.0, 0.05);
  raster.CoordinateSystem = "EPSG:4326+5773"; // EGM96
  Point without = { { 0.0, 0.0, 0.0 } };
  for (const bool isInstalled : { false, true })
  {
    CHECK_CASE(isInstalled);
    const std::string folder = folders.File(isInstalled ? "Geoids" : "NoGeoids");
    if (isInstalled)
    {
      WriteGeoid(folder);
    }
    setenv("GEOGRAPHICLIB_GEOID_PATH", folder.c_str(), 1);
    GlobeScene scene(raster, folders.File("GlobeGeoid.tif"));
    RelevoErrors warnings(scene.Mapper);
    scene.Mapper->SetExaggeration(2.0);
    const double geographic[3] = { 1.0, 9.0, 100.0 };
    double world[3];
    CHECK(scene.Mapper->GeographicToWorld(geographic, world));
    CHECK(isInstalled ? warnings.None() : warnings.Warned("egm96-5"));
    double back[3];
    CHECK(scene.Mapper->WorldToGeographic(world, back));
    CHECK_NEAR(back[2], 100.0, 1e-6);
    if (isInstalled)
    {
      CHECK_NEAR(std::sqrt(vtkMath::Distance2BetweenPoints(world, without.data())), 80.0, 0.01);
    }
    std::copy_n(world, 3, without.begin());
    // The picture has the same heights.
    scene.LookDown(1.0, 9.0, 20000.0);
    scene.Draw();
    vtkNew<vtkWorldPointPicker> picker;
    picker->Pick(WindowSize / 2.0, WindowSize / 2.0, 0.0, scene.Renderer);
    picker->GetPickPosition(world);
    CHECK(scene.Mapper->WorldToGeographic(world, back));
    CHECK_NEAR(back[2], scene.Pyramid->GetElevation(back[0], back[1]), 15.0);
  }
}

void TestErrors(RelevoCheck& check, const RelevoTestFolders& folders)
{
  RelevoRaster raster = MakeGlobe(20, 20, 0.0, 10.0, 0.5);
  raster.CoordinateSystem = "";
  GlobeScene scene(raster, folders.File("GlobeErrors.tif"));
  RelevoErrors errors(scene.Mapper);
  CHECK(!vtkMath::AreBoundsInitialized(scene.Mapper->GetBounds()));
  CHECK(errors.Said("no coordinate system"));
  scene.Mapper->SetFrame(2);
  CHECK(errors.Said("Frame must be"));
  CHECK_EQUAL(scene.Mapper->GetFrame(), vtkTerrainMapper::GEOCENTRIC);
}
}

int TestTerrainMapperGlobe(int argc, char* argv[])
{
  RelevoCheck check;
  const RelevoTestFolders folders(argc, argv);
  TestHoles(check, folders, MakeGlobe(720, 361, -180.25, 90.25, 0.5), "GlobeRows");
  TestHoles(check, folders, MakeGlobe(720, 360, -180.0, 90.0, 0.5), "GlobeCentres");
  TestPoles(check, folders);
  TestLongitudes(check, folders);
  TestImagery(check, folders);
  TestTranslucency(check, folders);
  TestMemory(check, folders);
  TestProjected(check, folders);
  TestMoon(check, folders);
  TestGeoid(check, folders);
  TestErrors(check, folders);
  return check.GetResult();
}
