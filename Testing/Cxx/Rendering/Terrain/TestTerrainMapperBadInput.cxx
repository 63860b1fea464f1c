// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkTerrainMapper and vtkTerrainPyramid with bad input: files that are replaced while they are
// open, reads that hang, rasters of unusual shapes, types and values, and absurd georeferences. Old
// and new heights never mix, frames go on, nothing waits for a read that hangs, and each error is
// reported once.
#include "RelevoHangingFiles.h"
#include "RelevoPyramidScene.h"
#include "RelevoRasterFiles.h"

#include "vtkCallbackCommand.h"
#include "vtkCamera.h"
#include "vtkLookupTable.h"
#include "vtkMath.h"
#include "vtkProperty.h"
#include "vtkTerrainMapper.h"
#include "vtkTerrainPyramid.h"
#include "vtkTerrainPyramidWriter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <memory>

namespace
{
namespace fs = std::filesystem;

constexpr int Size = 1100;
constexpr double Raised = 3000.0; // more than all heights of the hills
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinite = std::numeric_limits<double>::infinity();

RelevoRaster MakeRaster(int width, int height)
{
  return RelevoRaster::MakeMetric(width, height, 30.0);
}

// Hills and overviews.
void WriteHills(
  RelevoCheck& check, const RelevoTestFolders& folders, const std::string& name, double base)
{
  RelevoRaster raster = MakeRaster(Size, Size);
  raster.SetValues(
    [base](int, int column, int row)
    {
      return base + 900.0 + 500.0 * std::sin(column / 60.0) * std::cos(row / 80.0) +
        10.0 * std::cos(column / 3.0 - row / 4.0);
    });
  const std::string plain = folders.File("BadInputPlain.tif");
  CHECK(raster.Write(plain));
  vtkNew<vtkTerrainPyramidWriter> writer;
  writer->SetInputFileName(plain.c_str());
  writer->SetFileName(folders.File(name).c_str());
  writer->WriteIndexOff();
  CHECK(writer->Write());
}

class BadInputScene : public RelevoPyramidScene
{
public:
  explicit BadInputScene(const std::string& file)
    : RelevoPyramidScene(file)
    , MapperErrors(this->Mapper)
    , PyramidErrors(this->Pyramid)
  {
    vtkNew<vtkCallbackCommand> note;
    note->SetClientData(&this->IsUpdated);
    note->SetCallback(
      [](vtkObject*, unsigned long, void* data, void*) { *static_cast<bool*>(data) = true; });
    this->Mapper->AddObserver(vtkCommand::UpdateEvent, note);
    this->Mapper->SetColorModeToElevation();
    vtkNew<vtkLookupTable> table; // the hills are green, raised ones are red
    table->SetNumberOfTableValues(2);
    table->SetTableValue(0, 0.0, 1.0, 0.0);
    table->SetTableValue(1, 1.0, 0.0, 0.0);
    table->SetTableRange(0.0, 2.0 * Raised);
    this->Mapper->SetLookupTable(table);
    this->Actor->GetProperty()->LightingOff();
  }

  // Looks at the middle from a distance.
  void Look(double distance, double x = 0.0, double base = 900.0)
  {
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(x, -0.7 * distance, base + 0.7 * distance);
    camera->SetFocalPoint(x, 0.0, base);
    camera->SetViewUp(0.0, 0.0, 1.0);
    this->Renderer->ResetCameraClippingRange();
  }

  // Renders until there is no more to load.
  bool DrawAll()
  {
    this->IsUpdated = true;
    for (int i = 0; i < 100000 && this->IsUpdated; ++i)
    {
      this->IsUpdated = false;
      this->Window->Render();
    }
    return !this->IsUpdated;
  }

  size_t CountTerrain()
  {
    const RelevoPicture picture = this->Draw();
    return std::count_if(
      picture.Depths.begin(), picture.Depths.end(), [](float depth) { return depth < 1.0f; });
  }

  bool IsUpdated = false;
  RelevoErrors MapperErrors;
  RelevoErrors PyramidErrors;
};

// The file is replaced, or overwritten in place, while it is drawn. The tiles that are in memory
// are drawn on; others are not read from the new file, until Update() opens it.
void TestReplaced(RelevoCheck& check, const RelevoTestFolders& folders, bool isInPlace, int mode)
{
  CHECK_CASE(isInPlace);
  CHECK_CASE(mode);
  const std::string file = folders.File("BadInputReplaced.tif");
  const std::string other = folders.File("BadInputOther.tif");
  fs::copy_file(folders.File("BadInputHills.tif"), file, fs::copy_options::overwrite_existing);
  fs::copy_file(folders.File("BadInputRaised.tif"), other, fs::copy_options::overwrite_existing);
  BadInputScene scene(file);
  scene.Mapper->SetLoadingMode(mode);
  scene.Look(60000.0);
  CHECK(scene.DrawAll());
  CHECK_EQUAL(scene.CountRed(), 0);
  CHECK(scene.MapperErrors.None());
  const double place[2] = { 500000.0 + 700.0 * 30.0, 4300000.0 - 700.0 * 30.0 };
  if (isInPlace)
  {
    fs::copy_file(other, file, fs::copy_options::overwrite_existing);
  }
  else
  {
    fs::rename(other, file);
  }
  CHECK(std::isnan(scene.Pyramid->GetElevation(place[0], place[1])));
  CHECK(scene.PyramidErrors.Said("has changed since it was opened"));
  int reports = 0;
  scene.Mapper->SetScreenSpaceError(0.05);
  for (int i = 0; i < 5; ++i)
  {
    CHECK_CASE(i);
    scene.Look(3000.0, 4000.0 * (i - 2));
    CHECK(scene.DrawAll());
    CHECK_EQUAL(scene.CountRed(), 0);
    CHECK_GREATER(scene.CountTerrain(), 30000);
    CHECK(!scene.Mapper->IsComplete());
    reports += !scene.MapperErrors.None() &&
        scene.MapperErrors.Said("has changed since it was opened; open it again")
      ? 1
      : 0;
  }
  CHECK_EQUAL(reports, 1);
  CHECK(scene.Pyramid->Update());
  CHECK_GREATER(scene.Pyramid->GetElevation(place[0], place[1]), Raised);
  scene.Mapper->SetScreenSpaceError(1.0);
  scene.Look(3000.0, 0.0, 900.0 + Raised);
  CHECK(scene.DrawAll());
  CHECK(scene.Mapper->IsComplete());
  CHECK_GREATER(scene.CountRed(), 30000);
  CHECK(scene.MapperErrors.None());
  CHECK(scene.PyramidErrors.None());
}

// Frames go on while reads hang. Neither the mapper nor the pyramid waits for them at the end.
void TestHanging(RelevoCheck& check, const RelevoTestFolders& folders)
{
  const std::string file = RelevoHangingFiles::Prefix + folders.File("BadInputHills.tif");
  auto scene = std::make_unique<BadInputScene>(file);
  scene->Pyramid->SetCacheDirectory(folders.File("BadInputCache").c_str());
  CHECK(scene->Pyramid->Update() && scene->Pyramid->WaitForIndex());
  scene->Mapper->SetLoadingModeToBackground();
  scene->Look(60000.0);
  CHECK(scene->DrawAll());
  RelevoHangingFiles::Hang();
  for (int i = 0; i < 50; ++i)
  {
    scene->Look(2000.0, 100.0 * i);
    scene->Window->Render();
    CHECK(!scene->Mapper->IsComplete());
    CHECK(scene->IsUpdated);
    if (i == 5)
    {
      RelevoHangingFiles::WaitForHanging();
      CHECK_GREATER(scene->CountTerrain(), 30000);
    }
  }
  CHECK(scene->MapperErrors.None());
  scene.reset(); // a read hangs
  CHECK_GREATER(RelevoHangingFiles::GetNumberOfHanging(), 0);
  RelevoHangingFiles::Resume();
  RelevoHangingFiles::WaitForClosed(); // by the threads
}

// The same while the index is built.
void TestHangingIndex(RelevoCheck& check, const RelevoTestFolders& folders)
{
  const std::string file = RelevoHangingFiles::Prefix + folders.File("BadInputHills.tif");
  const std::string cache = folders.File("BadInputHangingCache");
  fs::remove_all(cache);
  {
    vtkNew<vtkTerrainPyramid> pyramid;
    pyramid->SetFileName(file.c_str());
    pyramid->SetCacheDirectory(cache.c_str());
    vtkNew<vtkCallbackCommand> stop; // after the first event of progress
    stop->SetCallback(
      [](vtkObject* caller, unsigned long, void*, void*)
      {
        RelevoHangingFiles::Hang();
        static_cast<vtkTerrainPyramid*>(caller)->AbortExecuteOn();
      });
    CHECK(pyramid->Update());
    RelevoHangingFiles::Hang();
    pyramid->AddObserver(vtkCommand::ProgressEvent, stop);
    CHECK(!pyramid->WaitForIndex());
  }
  RelevoHangingFiles::Resume();
  RelevoHangingFiles::WaitForClosed();
  // Nothing is lost: another pyramid makes the index.
  vtkNew<vtkTerrainPyramid> pyramid;
  RelevoErrors errors(pyramid);
  pyramid->SetFileName(file.c_str());
  pyramid->SetCacheDirectory(cache.c_str());
  CHECK(pyramid->Update());
  CHECK(pyramid->WaitForIndex());
  CHECK(errors.None());
}

// Draws a raster from above and from the side. Returns the pixels that it covers.
size_t DrawRaster(RelevoCheck& check, BadInputScene& scene, double base)
{
  size_t pixels = 0;
  for (int mode : { vtkTerrainMapper::COLOR_BY_HILLSHADE, vtkTerrainMapper::COLOR_SOLID })
  {
    CHECK_CASE(mode);
    scene.Mapper->SetTerrainColorMode(mode);
    scene.Mapper->SetContourInterval(mode == vtkTerrainMapper::COLOR_SOLID ? 10.0 : 0.0);
    scene.Look(1500.0, 0.0, base);
    CHECK(scene.DrawAll());
    scene.Look(20000.0, 0.0, base);
    CHECK(scene.DrawAll());
    pixels = scene.CountTerrain();
  }
  return pixels;
}

// Rasters whose values are unusual. Those with data are drawn, and nothing is an error.
void TestValues(RelevoCheck& check, const RelevoTestFolders& folders)
{
  struct Case
  {
    const char* Name;
    GDALDataType Type;
    double (*Value)(int column, int row);
    bool HasData;
  };
  const Case cases[] = {
    { "constant", GDT_Int16, [](int, int) { return 12.0; }, true },
    { "int32", GDT_Int32, [](int column, int row) { return 100000.0 + column + row; }, true },
    { "lowest int32", GDT_Int32, [](int, int) { return -2147483648.0; }, true },
    { "float64", GDT_Float64, [](int column, int row) { return 0.1 * column + 0.01 * row; }, true },
    { "some NaN", GDT_Float32, [](int column, int) { return column % 50 < 9 ? NaN : 70.0; }, true },
    { "some infinite", GDT_Float32,
      [](int column, int) {
        return column % 50 < 9 ? Infinite : column % 50 < 12 ? -Infinite : 7.0;
      },
      true },
    { "all NaN", GDT_Float32, [](int, int) { return NaN; }, false },
    { "all infinite", GDT_Float64, [](int, int) { return Infinite; }, false },
    { "all without data", GDT_Float32, [](int, int) { return -9999.0; }, false },
  };
  for (const Case& one : cases)
  {
    CHECK_CASE(one.Name);
    const std::string file = folders.File("BadInputValues.tif");
    RelevoRaster raster = MakeRaster(300, 270);
    raster.Type = one.Type;
    raster.NoData = -9999.0;
    raster.SetValues([&one](int, int column, int row) { return one.Value(column, row); });
    CHECK(raster.Write(file));
    BadInputScene scene(file);
    const size_t pixels = DrawRaster(check, scene, one.HasData ? one.Value(29, 0) : 0.0);
    CHECK_EQUAL(pixels > 0, one.HasData);
    CHECK(scene.Mapper->IsComplete() || !one.HasData); // VTK skips actors without bounds
    CHECK(scene.Pyramid->WaitForIndex());
    CHECK(scene.MapperErrors.None());
    CHECK(scene.PyramidErrors.None());
    const double* bounds = scene.Mapper->GetBounds();
    CHECK_EQUAL(vtkMath::AreBoundsInitialized(bounds) != 0, one.HasData);
    const double height = scene.Pyramid->GetElevation(500000.0 + 30.0 * 29.5, 4300000.0 - 15.0);
    const double expected = raster.At(0, 29, 0);
    CHECK_EQUAL(std::isnan(height), !one.HasData);
    CHECK(!one.HasData || height == (one.Type == GDT_Float32 ? float(expected) : expected));
  }
}

// Doubles that are out of the range of floats, or near its end: heights are returned. Nothing
// crashes or loads without an end, and there is at most one error.
void TestHugeValues(RelevoCheck& check, const RelevoTestFolders& folders)
{
  for (const double largest : { 2e34, 3e38, 1e39, 1e300 })
  {
    CHECK_CASE(largest);
    const std::string file = folders.File("BadInputHuge.tif");
    RelevoRaster raster = MakeRaster(300, 270);
    raster.Type = GDT_Float64;
    raster.SetValues(
      [largest](int, int column, int row) {
        return (column + row) % 7 == 0 ? largest : column % 5 == 0 ? -largest : 100.0;
      });
    CHECK(raster.Write(file));
    BadInputScene scene(file);
    DrawRaster(check, scene, 100.0);
    CHECK_LESS(scene.Mapper->GetNumberOfDrawnTriangles(), 20000000);
    if (!scene.MapperErrors.None())
    {
      CHECK(scene.MapperErrors.Said("BadInputHuge.tif"));
    }
    scene.Look(900.0);
    CHECK(scene.DrawAll());
    CHECK(scene.MapperErrors.None());
    CHECK(scene.PyramidErrors.None());
    CHECK_EQUAL(scene.Pyramid->GetElevation(500000.0 + 15.0, 4300000.0 - 15.0), largest);
    double range[2];
    scene.Pyramid->GetRange(range);
    CHECK_LESS_EQUAL(range[0], -largest);
    CHECK_GREATER_EQUAL(range[1], largest);
  }
}

// A camera that sees nothing, because its matrix is not finite, asks for no further frames. The
// next view is drawn as always.
void TestInfiniteView(RelevoCheck& check, const RelevoTestFolders& folders)
{
  for (int mode : { vtkTerrainMapper::BACKGROUND, vtkTerrainMapper::COMPLETE })
  {
    CHECK_CASE(mode);
    BadInputScene scene(folders.File("BadInputHills.tif"));
    scene.Mapper->SetLoadingMode(mode);
    vtkCamera* camera = scene.Renderer->GetActiveCamera();
    camera->ParallelProjectionOn();
    camera->SetParallelScale(0.0);
    CHECK(scene.DrawAll());
    CHECK_EQUAL(scene.Mapper->GetNumberOfDrawnTriangles(), 0);
    camera->ParallelProjectionOff();
    scene.Look(3000.0);
    CHECK(scene.DrawAll());
    CHECK_GREATER(scene.CountTerrain(), 30000);
    CHECK(scene.Mapper->IsComplete());
    CHECK(scene.MapperErrors.None());
    CHECK(scene.PyramidErrors.None());
  }
}

void TestShapes(RelevoCheck& check, const RelevoTestFolders& folders)
{
  const std::array<int, 2> sizes[] = { { { 1, 1 } }, { { 700, 1 } }, { { 1, 700 } }, { { 2, 2 } },
    { { 2, 700 } }, { { 700, 2 } } };
  for (const std::array<int, 2>& size : sizes)
  {
    CHECK_CASE(size[0]);
    CHECK_CASE(size[1]);
    const std::string file = folders.File("BadInputShape.tif");
    RelevoRaster raster = MakeRaster(size[0], size[1]);
    raster.SetValues([](int, int column, int row) { return 40.0 + column % 7 + row % 5; });
    CHECK(raster.Write(file));
    BadInputScene scene(file);
    const bool isLine = size[0] == 1 || size[1] == 1;
    const size_t pixels = DrawRaster(check, scene, 40.0);
    CHECK(!isLine || pixels == 0);
    CHECK(!isLine || scene.MapperErrors.Said("only one row or column"));
    CHECK_EQUAL(scene.Mapper->IsComplete(), !isLine);
    CHECK(scene.MapperErrors.None());
    CHECK_EQUAL(scene.Pyramid->GetElevation(500000.0 + 15.0, 4300000.0 - 15.0), 40.0);
    double range[2];
    scene.Pyramid->GetRange(range);
    CHECK_EQUAL(range[0], 40.0);
    CHECK(scene.PyramidErrors.None());
  }
}

// Each is drawn, or is one error.
void TestGeoreferences(RelevoCheck& check, const RelevoTestFolders& folders)
{
  struct Case
  {
    const char* Name;
    std::vector<double> Transform;
    const char* System;
    const char* Error; // nullptr if the raster is drawn
    bool IsOpened;     // otherwise the pyramid reports the error, not the mapper
  };
  const Case cases[] = {
    { "none", {}, "", nullptr, true },
    { "no system", { 500000.0, 30.0, 0.0, 4300000.0, 0.0, -30.0 }, "", nullptr, true },
    { "local", { 500000.0, 30.0, 0.0, 4300000.0, 0.0, -30.0 }, "LOCAL_CS[\"plan\"]", nullptr,
      true },
    { "latitudes", { 10.0, 1.0, 0.0, 400.0, 0.0, -1.0 }, "EPSG:4326", "beyond the poles", false },
    { "no area", { 0.0, 1.0, 1.0, 0.0, 1.0, 1.0 }, "EPSG:32632", "georeference is singular",
      false },
    { "NaN", { NaN, 30.0, 0.0, 0.0, 0.0, -30.0 }, "EPSG:32632", "georeference", false },
    { "huge", { 0.0, 1e38, 0.0, 0.0, 0.0, -1e38 }, "EPSG:32632", "invalid georeference", true },
    { "far away", { 1e300, 30.0, 0.0, 4300000.0, 0.0, -30.0 }, "EPSG:32632", "invalid georeference",
      true },
  };
  for (const Case& one : cases)
  {
    CHECK_CASE(one.Name);
    const std::string file = folders.File("BadInputGeoreference.tif");
    RelevoRaster raster = MakeRaster(200, 150);
    raster.Transform = one.Transform;
    raster.CoordinateSystem = one.System;
    raster.SetValues([](int, int column, int row) { return 20.0 + column % 7 + row % 5; });
    CHECK(raster.Write(file));
    BadInputScene scene(file);
    scene.Look(60000.0);
    CHECK(scene.DrawAll());
    CHECK_EQUAL(scene.Mapper->IsComplete(), one.Error == nullptr);
    if (one.Error)
    {
      CHECK((one.IsOpened ? scene.MapperErrors : scene.PyramidErrors).Said(one.Error));
    }
    CHECK(scene.DrawAll());
    CHECK(scene.MapperErrors.None()); // once
    CHECK(scene.PyramidErrors.None());
  }
}

void TestLowestLimit(RelevoCheck& check)
{
  vtkNew<vtkTerrainMapper> mapper;
  RelevoErrors errors(mapper);
  const vtkTypeInt64 before = mapper->GetMemoryLimit();
  mapper->SetMemoryLimit((1 << 22) - 1);
  CHECK(errors.Said("MemoryLimit must be at least 4194304, got 4194303."));
  CHECK_EQUAL(mapper->GetMemoryLimit(), before);
  mapper->SetMemoryLimit(1 << 22);
  CHECK(errors.None());
  CHECK_EQUAL(mapper->GetMemoryLimit(), 1 << 22);
}

// The pyramid reports a file that cannot be opened once, for Update() and all frames.
void TestMissingFile(RelevoCheck& check, const RelevoTestFolders& folders)
{
  BadInputScene scene(folders.File("BadInputMissing.tif"));
  int reports = 0;
  for (int i = 0; i < 3; ++i)
  {
    CHECK(!scene.Pyramid->Update());
    scene.Look(3000.0);
    scene.Window->Render();
    CHECK(!scene.Mapper->IsComplete());
    reports += !scene.PyramidErrors.None() && scene.PyramidErrors.Said("does not exist") ? 1 : 0;
    CHECK(scene.MapperErrors.None());
  }
  CHECK_EQUAL(reports, 1);
  // Another name is another error.
  const std::string other = folders.File("BadInputNoFile.tif");
  scene.Pyramid->SetFileName(other.c_str());
  scene.Window->Render();
  CHECK(scene.PyramidErrors.Said("BadInputNoFile.tif"));
  CHECK(scene.MapperErrors.None());
  scene.Mapper->SetPyramid(nullptr);
  scene.Window->Render();
  CHECK(scene.MapperErrors.Said("call SetPyramid()"));
}

// 16 MiB are sufficient for a picture. Otherwise it is coarser, which the mapper reports.
void TestSmallLimit(RelevoCheck& check, const RelevoTestFolders& folders)
{
  const std::string file = folders.File("BadInputHills.tif");
  for (int mode : { vtkTerrainMapper::BACKGROUND, vtkTerrainMapper::COMPLETE })
  {
    CHECK_CASE(mode);
    BadInputScene scene(file);
    scene.Mapper->SetLoadingMode(mode);
    scene.Mapper->SetMemoryLimit(vtkTypeInt64(1) << 24);
    scene.Mapper->SetScreenSpaceError(0.01);
    for (int i = 0; i < 5; ++i)
    {
      CHECK_CASE(i);
      scene.Look(3000.0, 4000.0 * (i - 2));
      CHECK(scene.DrawAll());
      CHECK_GREATER(scene.CountTerrain(), 30000);
      CHECK_LESS_EQUAL(scene.Mapper->GetResidentMemorySize(), vtkTypeInt64(1) << 24);
      const bool isMet = scene.Mapper->GetScreenSpaceErrorInUse() <= 0.01;
      CHECK_EQUAL(scene.Mapper->IsComplete(), isMet);
    }
    CHECK(scene.MapperErrors.None());
    CHECK(scene.PyramidErrors.None());
  }
}
}

int TestTerrainMapperBadInput(int argc, char* argv[])
{
  RelevoCheck check;
  const RelevoTestFolders folders(argc, argv);
  RelevoHangingFiles::Install();
  WriteHills(check, folders, "BadInputHills.tif", 0.0);
  WriteHills(check, folders, "BadInputRaised.tif", Raised);
  for (int mode : { vtkTerrainMapper::BACKGROUND, vtkTerrainMapper::COMPLETE })
  {
    TestReplaced(check, folders, false, mode);
    TestReplaced(check, folders, true, mode);
  }
  TestHanging(check, folders);
  TestHangingIndex(check, folders);
  TestValues(check, folders);
  TestHugeValues(check, folders);
  TestInfiniteView(check, folders);
  TestShapes(check, folders);
  TestGeoreferences(check, folders);
  TestSmallLimit(check, folders);
  TestLowestLimit(check);
  TestMissingFile(check, folders);
  return check.GetResult();
}
