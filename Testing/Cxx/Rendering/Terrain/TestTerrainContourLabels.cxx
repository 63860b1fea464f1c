// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Labels lie on contour lines of the full resolution, are visible, apart from each other, and stay
// at their places while the camera moves.
#include "RelevoPyramidScene.h"
#include "RelevoRasterFiles.h"

#include "vtkMath.h"
#include "vtkProperty.h"
#include "vtkTerrainContourLabels.h"
#include "vtkTextProperty.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <vector>

namespace
{
constexpr int Size = 700;
constexpr double Spacing = 30.0; // metres
constexpr int Width = 800;
constexpr int Height = 500;

using Point = std::array<double, 3>;

std::string WriteHills(RelevoCheck& check, const RelevoTestFolders& folders)
{
  RelevoRaster raster = RelevoRaster::MakeMetric(Size, Size, Spacing);
  raster.SetValues(
    [](int, int column, int row)
    {
      return 907.0 + 400.0 * std::sin(column / 40.0) * std::cos(row / 50.0) +
        90.0 * std::sin(column / 19.0 + row / 31.0);
    });
  const std::string file = folders.File("TerrainContourLabels.tif");
  CHECK(raster.Write(file));
  return file;
}

class LabelScene : public RelevoPyramidScene
{
public:
  LabelScene(const std::string& file, bool isGlobe)
    : RelevoPyramidScene(file, Width, Height)
  {
    this->Renderer->SetBackground(0.2, 0.3, 0.5);
    this->Mapper->SetContourInterval(50.0);
    this->Mapper->SetExaggeration(1.5);
    if (isGlobe)
    {
      this->Mapper->SetFrameToGeocentric();
    }
    this->Labels->SetActor(this->Actor);
    this->Labels->SetSpacing(90.0);
    this->Renderer->AddViewProp(this->Labels);
  }

  // Looks from a place to the centre, both in metres from it and above the zero of heights.
  void Look(double east, double north, double height)
  {
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(this->ToWorld(east, north, height).data());
    camera->SetFocalPoint(this->ToWorld(0.0, 0.0, 900.0).data());
    const Point high = this->ToWorld(0.0, 0.0, 2000.0);
    const Point low = this->ToWorld(0.0, 0.0, 1000.0);
    camera->SetViewUp(high[0] - low[0], high[1] - low[1], high[2] - low[2]);
    this->Renderer->ResetCameraClippingRange();
  }

  Point ToWorld(double east, double north, double height)
  {
    const double half = 0.5 * Size * Spacing;
    const double raster[2] = { 500000.0 + half + east, 4300000.0 - half + north };
    Point geographic = { { 0.0, 0.0, height } };
    this->Pyramid->RasterToGeographic(raster, geographic.data());
    Point world;
    this->Mapper->GeographicToWorld(geographic.data(), world.data());
    return world;
  }

  // The height of a point, without the exaggeration, and that of the full resolution below it.
  std::array<double, 2> GetHeights(const Point& world)
  {
    Point geographic;
    this->Mapper->WorldToGeographic(world.data(), geographic.data());
    std::array<double, 2> raster;
    this->Pyramid->GeographicToRaster(geographic.data(), raster.data());
    return { { geographic[2], this->Pyramid->GetElevation(raster[0], raster[1]) } };
  }

  std::vector<Point> GetPositions()
  {
    std::vector<Point> positions(this->Labels->GetNumberOfLabels());
    for (std::size_t i = 0; i < positions.size(); ++i)
    {
      this->Labels->GetLabelPosition(static_cast<int>(i), positions[i].data());
    }
    return positions;
  }

  // Pixels, and the depth.
  Point ToDisplay(const Point& world)
  {
    this->Renderer->SetWorldPoint(world[0], world[1], world[2], 1.0);
    this->Renderer->WorldToDisplay();
    Point display;
    this->Renderer->GetDisplayPoint(display.data());
    return display;
  }

  vtkNew<vtkTerrainContourLabels> Labels;
};

// The terrain does not reach the line from the eye to a point, except next to the point.
bool IsVisible(LabelScene& scene, const Point& point, double tolerance)
{
  Point eye;
  scene.Renderer->GetActiveCamera()->GetPosition(eye.data());
  for (int i = 1; i < 300; ++i)
  {
    const double t = i / 300.0;
    const auto heights = scene.GetHeights({ { eye[0] + t * (point[0] - eye[0]),
      eye[1] + t * (point[1] - eye[1]), eye[2] + t * (point[2] - eye[2]) } });
    if (heights[0] < heights[1] - tolerance) // false for NaN, outside of the raster
    {
      return false;
    }
  }
  return true;
}

void CheckLabels(RelevoCheck& check, LabelScene& scene)
{
  const std::vector<Point> positions = scene.GetPositions();
  CHECK_GREATER(positions.size(), 5);
  Point eye;
  scene.Renderer->GetActiveCamera()->GetPosition(eye.data());
  const double angle = scene.Renderer->GetActiveCamera()->GetViewAngle();
  double largest = 0.0;
  for (std::size_t i = 0; i < positions.size(); ++i)
  {
    const double value = scene.Labels->GetLabelValue(static_cast<int>(i));
    CHECK_EQUAL(std::fmod(value, 50.0), 0.0);
    const auto heights = scene.GetHeights(positions[i]);
    const double pixel = 2.0 * std::tan(vtkMath::RadiansFromDegrees(0.5 * angle)) *
      std::sqrt(vtkMath::Distance2BetweenPoints(eye.data(), positions[i].data())) / Height;
    // Metres are lengths in the world divided by the exaggeration.
    const double metres = pixel / scene.Mapper->GetExaggeration();
    CHECK_NEAR(heights[0], value, 1e-3);
    largest = std::max(largest, std::abs(heights[1] - value) / metres);
    CHECK(IsVisible(scene, positions[i], 4.0 * metres));
    const Point display = scene.ToDisplay(positions[i]);
    CHECK(display[0] > 4.0 && display[0] < Width - 4.0);
    CHECK(display[1] > 4.0 && display[1] < Height - 4.0);
    for (std::size_t j = 0; j < i; ++j)
    {
      const Point other = scene.ToDisplay(positions[j]);
      CHECK_GREATER(std::hypot(display[0] - other[0], display[1] - other[1]), 0.7 * 90.0 - 0.1);
    }
  }
  std::cout << positions.size() << " labels, at most " << largest << " pixels from their heights\n";
  CHECK_LESS(largest, 1.0);
}

void TestFrames(RelevoCheck& check, const std::string& file, const RelevoTestFolders& folders)
{
  for (bool isGlobe : { false, true })
  {
    CHECK_CASE(isGlobe);
    LabelScene scene(file, isGlobe);
    scene.Draw(); // opens the raster
    scene.Look(-2500.0, -9500.0, 4500.0);
    scene.Draw().Save(folders.File(isGlobe ? "ContourLabelsGlobe.png" : "ContourLabels.png"));
    CheckLabels(check, scene);
    const std::vector<Point> before = scene.GetPositions();
    // A small step
    scene.Look(-2400.0, -9400.0, 4520.0);
    scene.Draw();
    CheckLabels(check, scene);
    const std::vector<Point> after = scene.GetPositions();
    int kept = 0;
    for (const Point& old : before)
    {
      kept += std::any_of(after.begin(), after.end(),
                [&](const Point& point)
                { return vtkMath::Distance2BetweenPoints(old.data(), point.data()) < 1.0; })
        ? 1
        : 0;
    }
    CHECK_GREATER_EQUAL(kept, 0.85 * before.size());
    // A close view, in which labels are exact.
    scene.Look(-300.0, -2500.0, 2100.0);
    scene.Draw();
    CheckLabels(check, scene);
    // From above, nothing hides a label, and there are more of them.
    scene.Look(0.0, -10.0, 18000.0);
    scene.Draw();
    CheckLabels(check, scene);
    CHECK_GREATER(scene.Labels->GetNumberOfLabels(), 20);
  }
}

// Labels with multisampling, on an actor with a matrix, and with settings of others.
void TestSettings(RelevoCheck& check, const std::string& file)
{
  LabelScene scene(file, false);
  scene.Labels->GetTextProperty()->SetColor(1.0, 0.0, 0.0);
  scene.Labels->GetTextProperty()->SetBackgroundOpacity(0.0);
  scene.Labels->GetTextProperty()->SetFontSize(24);
  scene.Labels->GetTextProperty()->BoldOn();
  scene.Actor->GetProperty()->LightingOff();
  scene.Draw();
  scene.Look(-2500.0, -9500.0, 4500.0);
  CHECK_GREATER(scene.CountRed(), 100);
  const int number = scene.Labels->GetNumberOfLabels();
  scene.Labels->SetSpacing(300.0);
  LabelScene other(file, false);
  other.Labels->ShallowCopy(scene.Labels);
  other.Labels->SetActor(other.Actor);
  other.Window->SetMultiSamples(4);
  other.Draw();
  other.Look(-2500.0, -9500.0, 4500.0);
  other.Draw();
  CHECK_GREATER(other.Labels->GetNumberOfLabels(), 1);
  CHECK_LESS(other.Labels->GetNumberOfLabels(), number);
  // The labels move with the actor.
  scene.Labels->SetSpacing(90.0);
  scene.Mapper->SetContourInterval(100.0);
  scene.Draw();
  const Point before = scene.GetPositions()[0];
  scene.Actor->SetPosition(0.0, 0.0, 100.0);
  scene.Draw();
  const std::vector<Point> moved = scene.GetPositions();
  CHECK(std::any_of(moved.begin(), moved.end(),
    [&](const Point& point)
    {
      return std::abs(point[0] - before[0]) < 1e-3 && std::abs(point[2] - before[2] - 100.0) < 1e-3;
    }));
  scene.Mapper->SetContourInterval(0.0);
  CHECK_EQUAL(scene.CountRed(), 0);
  CHECK_EQUAL(scene.Labels->GetNumberOfLabels(), 0);
  CHECK(std::isnan(scene.Labels->GetLabelValue(0)));
  scene.Mapper->SetContourInterval(50.0);
  scene.Labels->SetActor(nullptr);
  CHECK_EQUAL(scene.CountRed(), 0);
  RelevoErrors errors(scene.Labels);
  scene.Labels->SetSpacing(1.0);
  CHECK(errors.Said("Spacing"));
  CHECK_EQUAL(scene.Labels->GetSpacing(), 90.0);
}

// Labels lie beside missing data, not on them.
void TestNoData(RelevoCheck& check, const RelevoTestFolders& folders)
{
  RelevoRaster raster = RelevoRaster::MakeMetric(Size, Size, Spacing);
  raster.NoData = -9999.0;
  raster.SetValues([](int, int column, int row)
    { return (column / 20 + row / 20) % 2 == 0 ? -9999.0 : 500.0 + 2.0 * column + row; });
  const std::string file = folders.File("TerrainContourLabelsHoles.tif");
  CHECK(raster.Write(file));
  LabelScene scene(file, false);
  scene.Draw();
  scene.Look(0.0, -10.0, 18000.0);
  scene.Draw().Save(folders.File("ContourLabelsHoles.png"));
  CHECK_GREATER(scene.Labels->GetNumberOfLabels(), 2);
  for (const Point& position : scene.GetPositions())
  {
    const auto heights = scene.GetHeights(position);
    CHECK_NEAR(heights[1], heights[0], 20.0); // a pixel, and NaN fails
  }
}
}

int TestTerrainContourLabels(int argc, char* argv[])
{
  RelevoCheck check;
  const RelevoTestFolders folders(argc, argv);
  const std::string file = WriteHills(check, folders);
  TestFrames(check, file, folders);
  TestSettings(check, file);
  TestNoData(check, folders);
  return check.GetResult();
}
