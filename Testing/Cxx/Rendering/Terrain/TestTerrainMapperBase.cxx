// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkTerrainMapper draws a solid that is closed to the pixel, and equals that of
// vtkTerrainMeshSource.
#include "RelevoPyramidScene.h"
#include "RelevoRasterFiles.h"

#include "vtkCellPicker.h"
#include "vtkHardwareSelector.h"
#include "vtkLookupTable.h"
#include "vtkMath.h"
#include "vtkPlane.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkTerrainMeshSource.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <random>

namespace
{
constexpr int NumberOfViews = 24;
constexpr double Opacity = 0.25;

enum class Holes
{
  None,
  Few,     // with corners that touch, islands, and holes at the borders
  Checkers // all corners touch
};

bool IsHole(Holes holes, int column, int row)
{
  if (holes == Holes::Checkers)
  {
    return (column / 8 + row / 8) % 2 == 0;
  }
  const double ring = std::hypot(column - 60, row - 50);
  return holes == Holes::Few &&
    ((ring > 18.0 && ring < 24.0) || column + row < 15 || (column / 5 == 3 && row % 10 < 6) ||
      (column > 90 && row > 80 && row < 90));
}

RelevoRaster MakeTerrain(int width, int height, Holes holes = Holes::None)
{
  RelevoRaster raster;
  raster.Width = width;
  raster.Height = height;
  raster.Transform = { 500000.0, 10.0, 0.0, 4200000.0, 0.0, -10.0 };
  raster.CoordinateSystem = "EPSG:32633";
  raster.NoData = -9999.0;
  raster.SetValues(
    [holes](int, int column, int row)
    {
      return IsHole(holes, column, row) ? -9999.0
                                        : 200.0 +
          90.0 * std::sin(column / 7.0) * std::cos(row / 11.0) + (column * 7 + row * 13) % 5;
    });
  return raster;
}

RelevoRaster MakeGeographic(int width, int height, Holes holes)
{
  RelevoRaster raster = MakeTerrain(width, height, holes);
  raster.Transform = { 10.0, 0.02, 0.0, 47.0, 0.0, -0.02 };
  raster.CoordinateSystem = "EPSG:4326";
  std::transform(raster.Values.begin(), raster.Values.end(), raster.Values.begin(),
    [](double height) { return height == -9999.0 ? height : 40.0 * height; });
  return raster;
}

class SolidScene : public RelevoPyramidScene
{
public:
  SolidScene(const RelevoRaster& raster, const std::string& file, double base)
    : RelevoPyramidScene(file, 200, 150)
    , Random(1)
  {
    raster.Write(file);
    std::filesystem::remove(file + ".relevo-index");
    this->Mapper->UseBaseOn();
    this->Mapper->SetBaseHeight(base);
    this->Actor->GetProperty()->LightingOff();
  }

  double Choose(double low, double high)
  {
    return std::uniform_real_distribution<double>(low, high)(this->Random);
  }

  vtkCamera* GetCamera() { return this->Renderer->GetActiveCamera(); }

  // Looks at a point of the solid from any side, also from below.
  void ChooseView()
  {
    double bounds[6];
    this->Mapper->GetBounds(bounds);
    double center[3];
    double direction[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      center[axis] = this->Choose(bounds[2 * axis], bounds[2 * axis + 1]);
      direction[axis] = this->Choose(-1.0, 1.0);
    }
    vtkMath::Normalize(direction);
    const double size =
      std::hypot(bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4]);
    const double distance = size * this->Choose(1.1, 2.0);
    vtkCamera* camera = this->GetCamera();
    camera->SetFocalPoint(center);
    camera->SetPosition(center[0] + distance * direction[0], center[1] + distance * direction[1],
      center[2] + distance * direction[2]);
    camera->SetViewUp(0.1, 0.2, 1.0);
    camera->SetViewAngle(this->Choose(2.0, 40.0));
    camera->SetParallelProjection(this->Choose(0.0, 1.0) < 0.3 ? 1 : 0);
    camera->SetParallelScale(size * this->Choose(0.02, 0.6));
    this->Mapper->SetScreenSpaceError(std::exp2(this->Choose(-1.0, 5.0)));
    this->Renderer->ResetCameraClippingRange();
  }

private:
  std::mt19937 Random;
};

// Every line of sight enters a closed solid as often as it leaves it: the translucent front and
// back faces of each pixel have the same number, and therefore the same colour.
void TestLayers(RelevoCheck& check, SolidScene& scene)
{
  vtkProperty* property = scene.Actor->GetProperty();
  property->SetOpacity(Opacity);
  size_t different = 0;
  size_t visible = 0;
  for (int view = 0; view < NumberOfViews; ++view)
  {
    scene.ChooseView();
    property->BackfaceCullingOn();
    const RelevoPicture fronts = scene.Draw();
    property->BackfaceCullingOff();
    property->FrontfaceCullingOn();
    const RelevoPicture backs = scene.Draw();
    property->FrontfaceCullingOff();
    for (size_t i = 0; i < fronts.GetNumberOfPixels(); ++i)
    {
      different += fronts.Colors[3 * i] == backs.Colors[3 * i] ? 0 : 1;
      visible += fronts.Colors[3 * i] > 0 ? 1 : 0;
    }
  }
  CHECK_EQUAL(different, 0);
  CHECK_GREATER(visible, 1000 * NumberOfViews);
  property->SetOpacity(1.0);
}

// The solid of vtkTerrainMeshSource for the camera of a scene.
class Twin
{
public:
  explicit Twin(SolidScene& scene)
    : Scene(scene)
  {
    this->Source->SetPyramid(scene.Pyramid);
    this->Source->SetCamera(scene.GetCamera());
    this->Source->SetViewportSize(scene.Window->GetSize());
    this->Source->SetBaseHeight(scene.Mapper->GetBaseHeight());
    this->Source->UseBaseOn();
    this->Source->SetExaggeration(scene.Mapper->GetExaggeration());
    this->Source->SetFrame(scene.Mapper->GetFrame());
    this->Mapper->SetInputConnection(this->Source->GetOutputPort());
    this->Mapper->ScalarVisibilityOff();
  }

  RelevoPicture Draw()
  {
    this->Source->SetScreenSpaceError(this->Scene.Mapper->GetScreenSpaceError());
    this->Mapper->SetClippingPlanes(this->Scene.Mapper->GetClippingPlanes());
    this->Scene.Actor->SetMapper(this->Mapper);
    RelevoPicture picture = this->Scene.Draw();
    this->Scene.Actor->SetMapper(this->Scene.Mapper);
    return picture;
  }

private:
  SolidScene& Scene;
  vtkNew<vtkTerrainMeshSource> Source;
  vtkNew<vtkPolyDataMapper> Mapper;
};

// Both solids cover the same pixels, at the same depth and, if it is given, in the same colours.
void TestTwin(RelevoCheck& check, SolidScene& scene, int tolerance = 255)
{
  Twin twin(scene);
  size_t different = 0;
  size_t visible = 0;
  for (int view = 0; view < NumberOfViews; ++view)
  {
    scene.ChooseView();
    const RelevoPicture drawn = scene.Draw();
    const RelevoPicture expected = twin.Draw();
    for (size_t i = 0; i < drawn.GetNumberOfPixels(); ++i)
    {
      const bool isSame = std::abs(drawn.Depths[i] - expected.Depths[i]) < 1e-3 &&
        std::abs(drawn.Colors[3 * i] - expected.Colors[3 * i]) <= tolerance;
      different += isSame ? 0 : 1;
      visible += drawn.Depths[i] < 1.0f ? 1 : 0;
    }
  }
  CHECK_GREATER(visible, 1000 * NumberOfViews);
  CHECK_LESS(different, visible / 2000);
}

void TestClosed(RelevoCheck& check, const std::string& file)
{
  for (Holes holes : { Holes::None, Holes::Few, Holes::Checkers })
  {
    CHECK_CASE(static_cast<int>(holes));
    SolidScene scene(MakeTerrain(120, 120, holes), file, 0.0);
    TestLayers(check, scene);
    TestTwin(check, scene);
  }
  const int sizes[][2] = { { 129, 129 }, { 300, 217 }, { 2, 2 }, { 5, 200 } };
  for (const auto& [width, height] : sizes)
  {
    CHECK_CASE(width);
    SolidScene scene(MakeTerrain(width, height), file, 50.0);
    scene.Mapper->SetExaggeration(1.5);
    TestLayers(check, scene);
    TestTwin(check, scene);
  }
  // With rows from the south to the north, and sheared
  RelevoRaster turned = MakeTerrain(120, 70, Holes::Few);
  turned.Transform = { 500000.0, 10.0, 3.0, 4200000.0, -2.0, 10.0 };
  SolidScene scene(turned, file, 50.0);
  TestLayers(check, scene);
  TestTwin(check, scene);
}

void TestGeocentric(RelevoCheck& check, const std::string& file)
{
  for (Holes holes : { Holes::None, Holes::Few })
  {
    CHECK_CASE(static_cast<int>(holes));
    SolidScene scene(MakeGeographic(150, 100, holes), file, -5000.0);
    scene.Mapper->SetFrameToGeocentric();
    TestLayers(check, scene);
    TestTwin(check, scene);
  }
}

// The number of translucent layers of a pixel; -1 for another colour.
int CountLayers(unsigned char color)
{
  double rest = 255.0;
  for (int layers = 0; layers < 8; ++layers)
  {
    if (std::abs(255.0 - rest - color) < 3.0)
    {
      return layers;
    }
    rest *= 1.0 - Opacity;
  }
  return -1;
}

// A translucent globe shows its far side: without a base, all lines of sight meet 2 layers.
void TestFarSide(RelevoCheck& check, SolidScene& scene)
{
  scene.Mapper->UseBaseOff();
  const RelevoPicture picture = scene.Draw();
  size_t numbers[8] = {};
  for (size_t i = 0; i < picture.GetNumberOfPixels(); ++i)
  {
    const int layers = CountLayers(picture.Colors[3 * i]);
    numbers[layers < 0 ? 7 : layers] += 1;
  }
  CHECK_GREATER(numbers[2], 2000);
  CHECK_LESS(numbers[1], 100);
  scene.Mapper->UseBaseOn();
}

// A globe is a shell without walls: lines of sight meet 2 or 4 layers.
void TestClosedGlobe(RelevoCheck& check, const std::string& file)
{
  RelevoRaster globe = MakeGeographic(72, 36, Holes::None);
  globe.Transform = { -180.0, 5.0, 0.0, 90.0, 0.0, -5.0 };
  SolidScene scene(globe, file, -3e6);
  scene.Mapper->SetFrameToGeocentric();
  scene.Actor->GetProperty()->SetOpacity(Opacity);
  for (double longitude : { 0.0, 120.0, 180.0, 240.0 })
  {
    const double angle = vtkMath::RadiansFromDegrees(longitude);
    scene.GetCamera()->SetPosition(3e7 * std::cos(angle), 3e7 * std::sin(angle), 1e7);
    scene.GetCamera()->SetFocalPoint(0.0, 0.0, 0.0);
    scene.GetCamera()->SetViewUp(0.0, 0.0, 1.0);
    scene.Renderer->ResetCameraClippingRange();
    const RelevoPicture picture = scene.Draw();
    size_t numbers[8] = {};
    size_t wrong = 0;
    for (size_t i = 0; i < picture.GetNumberOfPixels(); ++i)
    {
      const int layers = CountLayers(picture.Colors[3 * i]);
      wrong += layers != 0 && layers != 2 && layers != 4 ? 1 : 0;
      numbers[layers < 0 ? 7 : layers] += 1;
    }
    CHECK_GREATER(numbers[2], 1000);
    CHECK_GREATER(numbers[4], 1000);
    CHECK_LESS(wrong, 100);
    TestFarSide(check, scene);
  }
  RelevoErrors errors(scene.Mapper);
  scene.Mapper->SetExaggeration(3.0);
  scene.Draw();
  CHECK(errors.Said("the centre of the globe"));
}

// Walls and the bottom have the colour of the actor, flat normals and no contour lines.
void TestSides(RelevoCheck& check, const std::string& file)
{
  RelevoRaster flat = MakeTerrain(60, 45);
  flat.SetValues([](int, int, int) { return 300.0; });
  SolidScene scene(flat, file, 100.0);
  vtkProperty* property = scene.Actor->GetProperty();
  property->LightingOn();
  property->SetInterpolationToFlat();
  TestTwin(check, scene, 2);

  property->LightingOff();
  TestLayers(check, scene);
  property->SetColor(0.0, 0.0, 1.0);
  vtkNew<vtkLookupTable> red;
  red->SetNumberOfTableValues(1);
  red->SetTableValue(0, 1.0, 0.0, 0.0);
  red->SetTableRange(0.0, 1000.0);
  scene.Mapper->SetLookupTable(red);
  scene.Mapper->SetColorModeToElevation();
  scene.Mapper->SetContourInterval(10.0);
  scene.Mapper->SetContourWidth(3.0);
  scene.Mapper->SetContourColor(0.0, 1.0, 0.0);
  scene.GetCamera()->SetParallelProjection(0);
  scene.GetCamera()->SetFocalPoint(0.0, 0.0, 200.0);
  for (double height : { -300.0, 1000.0 })
  {
    CHECK_CASE(height);
    scene.GetCamera()->SetPosition(500.0, 1000.0, height);
    scene.Renderer->ResetCamera();
    const RelevoPicture picture = scene.Draw();
    size_t blue = 0;
    size_t others = 0;
    for (size_t i = 0; i < picture.GetNumberOfPixels(); ++i)
    {
      const unsigned char* color = &picture.Colors[3 * i];
      blue += color[2] == 255 && color[0] == 0 && color[1] == 0 ? 1 : 0;
      others += color[0] > 0 || color[1] > 0 ? 1 : 0;
    }
    CHECK_GREATER(blue, 500);
    CHECK_EQUAL(others > 0, height > 0.0); // the surface is out of sight from below
  }
}

// Depth peeling, clipping planes, lines, and hardware selection work as without a base.
void TestRendering(RelevoCheck& check, const std::string& file)
{
  RelevoRaster flat = MakeTerrain(60, 45);
  flat.SetValues([](int, int, int) { return 300.0; });
  SolidScene scene(flat, file, 100.0);
  vtkProperty* property = scene.Actor->GetProperty();
  property->SetOpacity(Opacity);
  scene.Renderer->UseDepthPeelingOn();
  scene.Renderer->SetMaximumNumberOfPeels(8);
  scene.Renderer->SetOcclusionRatio(0.0);
  size_t wrong = 0;
  size_t visible = 0;
  for (int view = 0; view < NumberOfViews; ++view)
  {
    scene.ChooseView();
    const RelevoPicture picture = scene.Draw();
    for (unsigned char color : picture.Colors)
    {
      wrong += CountLayers(color) == 0 || CountLayers(color) == 2 ? 0 : 1; // the box is convex
      visible += color > 0 ? 1 : 0;
    }
  }
  CHECK_GREATER(visible, 1000 * NumberOfViews);
  CHECK_LESS(wrong, visible / 10000); // at edges, both layers can have the same depth
  property->SetOpacity(1.0);
  scene.Renderer->UseDepthPeelingOff();

  vtkNew<vtkPlane> plane;
  plane->SetOrigin(20.0, 30.0, 200.0);
  plane->SetNormal(1.0, 0.4, 0.2);
  scene.Mapper->AddClippingPlane(plane);
  TestTwin(check, scene);
  scene.Mapper->RemoveAllClippingPlanes();
  property->SetRepresentationToWireframe();
  scene.GetCamera()->SetParallelProjection(0);
  scene.GetCamera()->SetFocalPoint(0.0, 0.0, 200.0);
  scene.GetCamera()->SetPosition(500.0, 1000.0, 700.0);
  scene.Renderer->ResetCamera();
  scene.Mapper->SetScreenSpaceError(1.0);
  Twin twin(scene);
  const RelevoPicture lines = scene.Draw();
  const RelevoPicture expected = twin.Draw();
  size_t different = 0;
  for (size_t i = 0; i < lines.GetNumberOfPixels(); ++i)
  {
    different += lines.Colors[3 * i] == expected.Colors[3 * i] ? 0 : 1;
  }
  CHECK_GREATER(lines.CountForeground(), 1000);
  CHECK_LESS(different, lines.CountForeground() / 100);
  property->SetRepresentationToPoints();
  CHECK_GREATER(scene.Draw().CountForeground(), 100);
  property->SetRepresentationToSurface();

  // From below, near the middle of the bottom and of a wall
  scene.GetCamera()->SetPosition(100.0, 1500.0, -500.0);
  scene.Renderer->ResetCamera();
  scene.Draw();
  vtkNew<vtkCellPicker> picker;
  picker->SetTolerance(0.0);
  CHECK_EQUAL(picker->Pick(100.0, 70.0, 0.0, scene.Renderer), 1);
  const double height = picker->GetPickPosition()[2];
  CHECK_GREATER(height, 99.9);
  CHECK_LESS(height, 299.0);
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(scene.Renderer);
  selector->SetArea(100, 70, 100, 70);
  selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_CELLS);
  selector->CaptureBuffers();
  const unsigned int pixel[2] = { 100, 70 };
  const auto selected = selector->GetPixelInformation(pixel);
  CHECK(selected.Valid && selected.Prop == scene.Actor.Get());
  CHECK_GREATER(selected.AttributeID, -1);
}

void TestSettings(RelevoCheck& check, const std::string& file)
{
  SolidScene scene(MakeTerrain(60, 45), file, -20.0);
  RelevoErrors errors(scene.Mapper);
  scene.Mapper->SetExaggeration(2.0);
  double bounds[6];
  scene.Mapper->GetBounds(bounds);
  CHECK_EQUAL(bounds[4], -40.0);
  scene.Mapper->UseBaseOff();
  scene.Mapper->GetBounds(bounds);
  CHECK_GREATER(bounds[4], 0.0);
  scene.GetCamera()->SetPosition(0.0, -2000.0, 700.0);
  scene.GetCamera()->SetFocalPoint(0.0, 0.0, 300.0);
  scene.GetCamera()->SetViewUp(0.0, 0.0, 1.0);
  scene.Renderer->ResetCamera();
  const RelevoPicture plain = scene.Draw();
  const vtkIdType triangles = scene.Mapper->GetNumberOfDrawnTriangles();
  CHECK(errors.None());
  // A base that is not below the terrain
  scene.Mapper->UseBaseOn();
  scene.Mapper->SetBaseHeight(150.0);
  CHECK(scene.Draw().Colors == plain.Colors);
  CHECK(errors.Said("BaseHeight is 150"));
  CHECK_EQUAL(scene.Mapper->GetNumberOfDrawnTriangles(), triangles);
  scene.Draw();
  CHECK(errors.None()); // once
  scene.Mapper->SetBaseHeight(std::numeric_limits<double>::quiet_NaN());
  CHECK(errors.Said("BaseHeight"));
  CHECK_EQUAL(scene.Mapper->GetBaseHeight(), 150.0);
  scene.Mapper->SetBaseHeight(0.0);
  CHECK_GREATER(scene.Draw().CountForeground(), plain.CountForeground() + 1000);
  CHECK(errors.None());
  vtkNew<vtkTerrainMapper> copy;
  copy->ShallowCopy(scene.Mapper);
  CHECK(copy->GetUseBase());
  CHECK_EQUAL(copy->GetBaseHeight(), 0.0);
}
}

int TestTerrainMapperBase(int argc, char* argv[])
{
  RelevoCheck check;
  const RelevoTestFolders folders(argc, argv);
  const std::string file = folders.File("TerrainMapperBase.tif");
  TestClosed(check, file);
  TestGeocentric(check, file);
  TestClosedGlobe(check, file);
  TestSides(check, file);
  TestRendering(check, file);
  TestSettings(check, file);
  return check.GetResult();
}
