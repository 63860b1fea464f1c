// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkTerrainMapper draws a raster file within its error, and reports results and errors.
#include "RelevoPyramidScene.h"
#include "RelevoRasterFiles.h"

#include "vtkCallbackCommand.h"
#include "vtkHardwareSelector.h"
#include "vtkLookupTable.h"
#include "vtkProperty.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"
#include "vtkTerrainMapper.h"
#include "vtkTerrainPyramid.h"
#include "vtkTerrainPyramidWriter.h"

#include <gdal.h>
#include <gdal_utils.h>

#include <algorithm>
#include <cmath>
#include <fstream>

namespace
{
constexpr int Size = 700;

// 30 m between samples, in a UTM zone.
RelevoRaster MakeRaster()
{
  return RelevoRaster::MakeMetric(Size, Size, 30.0);
}

// Hills in metres.
std::string WriteHills(const RelevoTestFolders& folders, const std::string& name)
{
  RelevoRaster raster = MakeRaster();
  raster.SetValues(
    [](int, int column, int row)
    {
      return 900.0 + 500.0 * std::sin(column / 60.0) * std::cos(row / 80.0) +
        120.0 * std::sin(column / 19.0 + row / 31.0) + 10.0 * std::cos(column / 3.0 - row / 4.0);
    });
  const std::string file = folders.File(name);
  return raster.Write(file) ? file : "";
}

class TerrainScene : public RelevoPyramidScene
{
public:
  explicit TerrainScene(const std::string& file)
    : RelevoPyramidScene(file)
  {
  }

  // Looks from a point above the map's lower border at its centre.
  void Look(double height = 5000.0)
  {
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(-2500.0, -11500.0, height);
    camera->SetFocalPoint(0.0, 0.0, 500.0);
    camera->SetViewUp(0.0, 0.0, 1.0);
    this->Renderer->ResetCameraClippingRange();
  }
};

// From above, with a sample per pixel, the slopes are those of gdaldem.
void TestSlopes(RelevoCheck& check, const std::string& file, const RelevoTestFolders& folders)
{
  const std::string slopeFile = folders.File("TerrainMapperSlopes.tif");
  GDALDatasetH source = GDALOpen(file.c_str(), GA_ReadOnly);
  CHECK(source != nullptr);
  int isUsedWrongly = 0;
  GDALDatasetH slopes =
    GDALDEMProcessing(slopeFile.c_str(), source, "slope", nullptr, nullptr, &isUsedWrongly);
  CHECK(slopes != nullptr);
  GDALClose(slopes);
  GDALClose(source);
  const RelevoRaster expected = RelevoRaster::Read(slopeFile);

  TerrainScene scene(file);
  scene.Window->SetSize(301, 301);
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  // The centre of the picture is sample (350, 350).
  camera->SetPosition(15.0, -15.0, 20000.0);
  camera->SetFocalPoint(15.0, -15.0, 0.0);
  camera->SetViewUp(0.0, 1.0, 0.0);
  camera->ParallelProjectionOn();
  camera->SetParallelScale(0.5 * 301 * 30.0);
  scene.Renderer->ResetCameraClippingRange();
  vtkNew<vtkLookupTable> table;
  table->SetNumberOfTableValues(256);
  table->SetHueRange(0.0, 0.0);
  table->SetSaturationRange(0.0, 0.0);
  table->SetValueRange(0.0, 1.0);
  table->SetRampToLinear();
  table->SetTableRange(0.0, 64.0);
  table->Build();
  scene.Mapper->SetLookupTable(table);
  scene.Mapper->SetColorModeToSlope();
  scene.Mapper->SetScreenSpaceError(20.0); // the faces are large
  scene.Actor->GetProperty()->LightingOff();
  const RelevoPicture picture = scene.Draw();
  picture.Save(folders.File("TerrainMapperSlopes.png"));
  CHECK_LESS(scene.Mapper->GetNumberOfDrawnTriangles(), 20000);
  double largest = 0.0;
  for (int y = 0; y < 301; ++y)
  {
    for (int x = 0; x < 301; ++x)
    {
      const double slope = expected.At(0, 200 + x, 500 - y);
      const size_t pixel = 3 * (static_cast<size_t>(y) * 301 + x);
      largest = std::max(largest, std::abs(slope - (picture.Colors[pixel] + 0.5) / 4.0));
    }
  }
  CHECK_LESS(largest, 0.3); // a colour of the table is a quarter of a degree
}

void TestResults(RelevoCheck& check, const std::string& file, const RelevoTestFolders& folders)
{
  TerrainScene scene(file);
  CHECK(scene.Pyramid->Update() && scene.Pyramid->WaitForIndex());
  const double* bounds = scene.Mapper->GetBounds();
  CHECK_NEAR(bounds[0], -10485.0, 1e-6);
  CHECK_NEAR(bounds[3], 10485.0, 1e-6);
  double range[2];
  scene.Pyramid->GetRange(range);
  CHECK_LESS_EQUAL(bounds[4], range[0] + 1e-3);
  CHECK_GREATER_EQUAL(bounds[5], range[1] - 1e-3);
  scene.Look();
  vtkIdType last = 0;
  for (double error : { 8.0, 2.0, 1.0, 0.5 })
  {
    CHECK_CASE(error);
    scene.Mapper->SetScreenSpaceError(error);
    const RelevoPicture picture = scene.Draw();
    picture.Save(folders.File("TerrainMapper.png"));
    CHECK_GREATER(picture.CountForeground(), picture.GetNumberOfPixels() / 3);
    CHECK(scene.Mapper->IsComplete());
    CHECK_LESS_EQUAL(scene.Mapper->GetScreenSpaceErrorInUse(), error + 1e-6);
    CHECK_GREATER(scene.Mapper->GetNumberOfDrawnTriangles(), last);
    last = scene.Mapper->GetNumberOfDrawnTriangles();
  }
  CHECK_GREATER(scene.Mapper->GetResidentMemorySize(), 4 * 259 * 259 * 4);
  CHECK_LESS_EQUAL(scene.Mapper->GetResidentMemorySize(), scene.Mapper->GetMemoryLimit());
  // Twice the heights need more triangles.
  scene.Mapper->SetExaggeration(2.0);
  scene.Draw();
  CHECK_GREATER(scene.Mapper->GetNumberOfDrawnTriangles(), last);
  CHECK_NEAR(scene.Mapper->GetBounds()[5], 2.0 * range[1], 1e-2);
}

void TestGeographic(RelevoCheck& check, const std::string& file)
{
  TerrainScene scene(file);
  scene.Mapper->SetExaggeration(3.0);
  const double world[3] = { 1000.0, -2000.0, 600.0 };
  double geographic[3];
  CHECK(scene.Mapper->WorldToGeographic(world, geographic));
  CHECK_NEAR(geographic[0], 9.132, 0.01);
  CHECK_NEAR(geographic[1], 38.735, 0.01);
  CHECK_NEAR(geographic[2], 200.0, 1e-9);
  double back[3];
  CHECK(scene.Mapper->GeographicToWorld(geographic, back));
  for (int axis = 0; axis < 3; ++axis)
  {
    CHECK_NEAR(back[axis], world[axis], 1e-3);
  }
  double raster[3];
  CHECK(scene.Mapper->WorldToRaster(world, raster));
  double coordinates[2];
  CHECK(scene.Pyramid->GeographicToRaster(geographic, coordinates));
  CHECK_NEAR(raster[0], coordinates[0], 1e-3);
  CHECK_NEAR(raster[1], coordinates[1], 1e-3);
  CHECK_NEAR(raster[2] * scene.Pyramid->GetVerticalUnit(), 200.0, 1e-9);
  CHECK(scene.Mapper->RasterToWorld(raster, back));
  CHECK_LESS(vtkMath::Distance2BetweenPoints(world, back), 1e-12);
}

void TestErrors(RelevoCheck& check)
{
  TerrainScene scene("");
  RelevoErrors errors(scene.Mapper);
  RelevoErrors pyramidErrors(scene.Pyramid);
  scene.Pyramid->SetFileName("/nowhere/terrain.tif");
  CHECK_EQUAL(scene.Draw().CountForeground(), 0);
  CHECK(pyramidErrors.Said("/nowhere/terrain.tif"));
  scene.Draw();
  CHECK(pyramidErrors.None() && errors.None()); // once
  scene.Mapper->SetPyramid(nullptr);
  scene.Draw();
  CHECK(errors.Said("SetPyramid()"));
  scene.Draw();
  CHECK(errors.None());
  CHECK(!scene.Mapper->IsComplete());
  CHECK_EQUAL(scene.Mapper->GetNumberOfDrawnTriangles(), 0);
  const double point[3] = { 0.0, 0.0, 0.0 };
  double other[3];
  CHECK(!scene.Mapper->GeographicToWorld(point, other));
  CHECK(!scene.Mapper->WorldToGeographic(point, other));
  CHECK(!scene.Mapper->RasterToWorld(point, other));
  CHECK(!scene.Mapper->WorldToRaster(point, other));
}

// Rasters that cannot be drawn, or only in part.
void TestBadRasters(RelevoCheck& check, const RelevoTestFolders& folders)
{
  RelevoRaster line = MakeRaster();
  line.Height = 1;
  line.SetValues([](int, int column, int) { return column; });
  RelevoRaster empty = MakeRaster();
  empty.NoData = -1.0;
  empty.CoordinateSystem = "";
  empty.SetValues([](int, int, int) { return -1.0; });
  CHECK(line.Write(folders.File("TerrainMapperLine.tif")));
  CHECK(empty.Write(folders.File("TerrainMapperEmpty.tif")));
  {
    TerrainScene scene(folders.File("TerrainMapperLine.tif"));
    RelevoErrors errors(scene.Mapper);
    scene.Look();
    CHECK_EQUAL(scene.Draw().CountForeground(), 0);
    CHECK(errors.Said("only one row or column"));
  }
  TerrainScene scene(folders.File("TerrainMapperEmpty.tif"));
  RelevoErrors errors(scene.Mapper);
  scene.Look();
  CHECK_EQUAL(scene.Draw().CountForeground(), 0);
  CHECK(errors.None());
  const double point[3] = { 0.0, 0.0, 0.0 };
  double other[3];
  CHECK(!scene.Mapper->GeographicToWorld(point, other)); // no coordinate system
  CHECK(!scene.Mapper->WorldToGeographic(point, other));
  CHECK(scene.Mapper->WorldToRaster(point, other));
  CHECK(scene.Mapper->RasterToWorld(other, other));
  CHECK_NEAR(other[0], 0.0, 1e-6);
  scene.Mapper->SetFrameToGeocentric();
  CHECK(!scene.Mapper->WorldToRaster(point, other));
}

// A tile that cannot be read is reported once, and the rest is drawn, without endless frames.
void TestUnreadable(RelevoCheck& check, const RelevoTestFolders& folders)
{
  RelevoRaster raster = MakeRaster();
  raster.SetValues([](int, int column, int row) { return (column * 7919 + row * 104729) % 100; });
  const std::string whole = folders.File("TerrainMapperWhole.tif");
  const std::string file = folders.File("TerrainMapperDamaged.tif");
  CHECK(raster.Write(whole));
  vtkNew<vtkTerrainPyramidWriter> writer;
  writer->SetInputFileName(whole.c_str());
  writer->SetFileName(file.c_str());
  CHECK(writer->Write());
  {
    // The full resolution takes three quarters of the file.
    std::fstream stream(file, std::ios::in | std::ios::out | std::ios::binary);
    stream.seekg(0, std::ios::end);
    const std::streamoff size = stream.tellg();
    stream.seekp(size / 2);
    stream << std::string(2000, 'x');
  }
  for (int mode : { vtkTerrainMapper::BACKGROUND, vtkTerrainMapper::COMPLETE })
  {
    CHECK_CASE(mode);
    TerrainScene scene(file);
    scene.Mapper->SetLoadingMode(mode);
    scene.Mapper->SetScreenSpaceError(0.5);
    RelevoErrors errors(scene.Mapper);
    RelevoErrors pyramidErrors(scene.Pyramid);
    bool isUpdated = true;
    vtkNew<vtkCallbackCommand> note;
    note->SetClientData(&isUpdated);
    note->SetCallback(
      [](vtkObject*, unsigned long, void* data, void*) { *static_cast<bool*>(data) = true; });
    scene.Mapper->AddObserver(vtkCommand::UpdateEvent, note);
    scene.Look();
    int reports = 0;
    for (int i = 0; i < 20000 && isUpdated; ++i)
    {
      isUpdated = false;
      scene.Window->Render();
      reports += !errors.None() && errors.Said("TerrainMapperDamaged.tif") ? 1 : 0;
    }
    CHECK(!isUpdated);
    CHECK_EQUAL(reports, 1);
    CHECK_GREATER(RelevoPicture(scene.Window).CountForeground(), 30000);
  }
}

// Background loading ends with the picture of complete loading, also if the index is built
// meanwhile.
void TestBackground(RelevoCheck& check, const RelevoTestFolders& folders)
{
  const std::string file = WriteHills(folders, "TerrainMapperNew.tif"); // its index is out of date
  TerrainScene scene(file);
  scene.Mapper->SetLoadingModeToBackground();
  scene.Look();
  int updates = 0;
  vtkNew<vtkCallbackCommand> count;
  count->SetClientData(&updates);
  count->SetCallback(
    [](vtkObject*, unsigned long, void* data, void*) { ++*static_cast<int*>(data); });
  scene.Mapper->AddObserver(vtkCommand::UpdateEvent, count);
  int frames = 0;
  do
  {
    scene.Window->Render();
    ++frames;
  } while (updates == frames && frames < 100000);
  CHECK_GREATER(frames, 1);
  CHECK(scene.Mapper->IsComplete());
  const RelevoPicture actual = scene.Draw();
  CHECK_EQUAL(updates, frames - 1);
  TerrainScene other(file);
  other.Look();
  CHECK(other.Draw().Colors == actual.Colors);
}

// With a limit that is too small, the picture is coarser and needs no further frames.
void TestMemoryLimit(RelevoCheck& check, const std::string& file)
{
  TerrainScene scene(file);
  scene.Mapper->SetScreenSpaceError(0.02);
  scene.Mapper->SetMemoryLimit(vtkTypeInt64(1) << 22);
  RelevoErrors errors(scene.Mapper);
  bool isUpdated = false;
  vtkNew<vtkCallbackCommand> note;
  note->SetClientData(&isUpdated);
  note->SetCallback(
    [](vtkObject*, unsigned long, void* data, void*) { *static_cast<bool*>(data) = true; });
  scene.Mapper->AddObserver(vtkCommand::UpdateEvent, note);
  for (int i = 0; i < 8; ++i)
  {
    CHECK_CASE(i);
    scene.Look(1200.0 + 300.0 * i);
    CHECK_GREATER(scene.Draw().CountForeground(), 30000);
    // An eighth of the limit is for the threads that read tiles.
    CHECK_LESS_EQUAL(scene.Mapper->GetResidentMemorySize(), scene.Mapper->GetMemoryLimit() / 8 * 7);
    CHECK_GREATER(scene.Mapper->GetScreenSpaceErrorInUse(), 0.02);
    CHECK(!scene.Mapper->IsComplete());
    CHECK(!isUpdated);
  }
  CHECK(errors.None());
  scene.Mapper->SetMemoryLimit(vtkTypeInt64(1) << 27);
  scene.Draw();
  CHECK(scene.Mapper->IsComplete());
  CHECK_LESS_EQUAL(scene.Mapper->GetScreenSpaceErrorInUse(), 0.02 + 1e-6);
}

// The passes of depth peeling draw the same faces while tiles arrive.
void TestTranslucency(RelevoCheck& check, const std::string& file)
{
  TerrainScene scene(file);
  scene.Look();
  scene.Actor->GetProperty()->SetOpacity(0.5);
  scene.Renderer->UseDepthPeelingOn();
  scene.Window->SetAlphaBitPlanes(1);
  const RelevoPicture expected = scene.Draw();
  TerrainScene other(file);
  other.Mapper->SetLoadingModeToBackground();
  other.Look();
  other.Actor->GetProperty()->SetOpacity(0.5);
  other.Renderer->UseDepthPeelingOn();
  other.Window->SetAlphaBitPlanes(1);
  int frames = 0;
  do
  {
    other.Window->Render();
    ++frames;
  } while (!other.Mapper->IsComplete() && frames < 100000);
  CHECK(other.Draw().Colors == expected.Colors);
}

void TestSelection(RelevoCheck& check, const std::string& file)
{
  TerrainScene scene(file);
  scene.Look();
  scene.Draw();
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(scene.Renderer);
  selector->SetArea(0, 0, 399, 299);
  selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_CELLS);
  auto selection = vtk::TakeSmartPointer(selector->Select());
  CHECK_EQUAL(selection->GetNumberOfNodes(), 1);
  CHECK_EQUAL(selection->GetNode(0)->GetProperties()->Get(vtkSelectionNode::PROP()), scene.Actor);
  const vtkIdType faces = scene.Mapper->GetNumberOfDrawnTriangles() / 64;
  const vtkIdType selected = selection->GetNode(0)->GetSelectionList()->GetNumberOfTuples();
  CHECK_GREATER(selected, 10);
  CHECK_LESS_EQUAL(selected, faces);
}

// A mapper that moves to another window and back draws the same. Several mappers share a pyramid.
void TestWindows(RelevoCheck& check, const std::string& file)
{
  TerrainScene scene(file);
  scene.Look();
  const RelevoPicture first = scene.Draw();
  {
    TerrainScene other(file);
    other.Look();
    other.Actor->SetMapper(scene.Mapper);
    CHECK(other.Draw().Colors == first.Colors);
    other.Mapper->SetPyramid(scene.Pyramid);
    other.Actor->SetMapper(other.Mapper);
    CHECK(other.Draw().Colors == first.Colors);
  }
  CHECK(scene.Draw().Colors == first.Colors);
  vtkNew<vtkTerrainMapper> copy;
  copy->ShallowCopy(scene.Mapper);
  scene.Actor->SetMapper(copy);
  CHECK(scene.Draw().Colors == first.Colors);
  scene.Actor->SetMapper(scene.Mapper);
}

// Another raster replaces the first one.
void TestOtherRaster(RelevoCheck& check, const std::string& file, const RelevoTestFolders& folders)
{
  TerrainScene scene(file);
  scene.Look();
  const RelevoPicture first = scene.Draw();
  RelevoRaster flat = MakeRaster();
  flat.SetValues([](int, int, int) { return 1000.0; });
  const std::string name = folders.File("TerrainMapperFlat.tif");
  CHECK(flat.Write(name));
  scene.Pyramid->SetFileName(name.c_str());
  const RelevoPicture second = scene.Draw();
  CHECK(second.Colors != first.Colors);
  // The picture has one colour and the background.
  CHECK_GREATER(second.CountForeground(), 5000);
  CHECK_LESS(second.CountForeground(), 40000);
  scene.Pyramid->SetFileName(file.c_str());
  CHECK(scene.Draw().Colors == first.Colors);
}

void TestColors(RelevoCheck& check, const std::string& file, const RelevoTestFolders& folders)
{
  TerrainScene scene(file);
  CHECK(scene.Pyramid->Update() && scene.Pyramid->WaitForIndex());
  scene.Look();
  const RelevoPicture solid = scene.Draw();
  double range[2];
  scene.Pyramid->GetRange(range);
  for (int mode : { vtkTerrainMapper::COLOR_BY_ELEVATION, vtkTerrainMapper::COLOR_BY_SLOPE,
         vtkTerrainMapper::COLOR_BY_ASPECT, vtkTerrainMapper::COLOR_BY_HILLSHADE })
  {
    CHECK_CASE(mode);
    scene.Mapper->SetTerrainColorMode(mode);
    const RelevoPicture picture = scene.Draw();
    picture.Save(folders.File("TerrainMapper.Colors" + std::to_string(mode) + ".png"));
    CHECK(picture.Colors != solid.Colors);
    CHECK(picture.Depths == solid.Depths);
    const double* used = scene.Mapper->GetLookupTable()->GetRange();
    CHECK_NEAR(used[1],
      (mode == vtkTerrainMapper::COLOR_BY_SLOPE       ? 90.0
          : mode == vtkTerrainMapper::COLOR_BY_ASPECT ? 360.0
                                                      : range[1]),
      1e-9);
  }
  // A table with translucent colours makes the terrain translucent.
  vtkNew<vtkLookupTable> table;
  table->SetRange(range);
  table->SetAlphaRange(0.2, 0.2);
  table->Build();
  scene.Mapper->SetLookupTable(table);
  CHECK(!scene.Mapper->HasTranslucentPolygonalGeometry());
  scene.Mapper->SetColorModeToElevation();
  CHECK(scene.Mapper->HasTranslucentPolygonalGeometry());
  CHECK(!scene.Mapper->HasOpaqueGeometry());
  CHECK_GREATER(scene.Draw().CountForeground(), 0);
  scene.Mapper->SetColorModeToHillshade();
  scene.Mapper->SetContourInterval(100.0);
  scene.Mapper->SetContourColor(0.5, 0.2, 0.0);
  scene.Draw().Save(folders.File("TerrainMapper.Contours.png"));
}
}

int TestTerrainMapper(int argc, char* argv[])
{
  RelevoCheck check;
  const RelevoTestFolders folders(argc, argv);
  const std::string file = WriteHills(folders, "TerrainMapper.tif");
  if (!CHECK(!file.empty()))
  {
    return check.GetResult();
  }
  TestResults(check, file, folders);
  TestSlopes(check, file, folders);
  TestGeographic(check, file);
  TestErrors(check);
  TestBadRasters(check, folders);
  TestUnreadable(check, folders);
  TestBackground(check, folders);
  TestMemoryLimit(check, file);
  TestTranslucency(check, file);
  TestSelection(check, file);
  TestWindows(check, file);
  TestOtherRaster(check, file, folders);
  TestColors(check, file, folders);
  return check.GetResult();
}
