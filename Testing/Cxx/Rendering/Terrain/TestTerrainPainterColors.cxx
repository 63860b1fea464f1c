// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Colours by height equal those of vtkPolyDataMapper. On planes, the other colours, the shading and
// contour lines are known.
#include "RelevoTerrainScene.h"

#include "vtkLookupTable.h"
#include "vtkMath.h"
#include "vtkProperty.h"

#include <algorithm>
#include <cmath>
#include <limits>

using relevo::TerrainColoring;

namespace
{
void LookFromAbove(RelevoTerrainScene& scene, double parallelScale)
{
  scene.Look({ { 256.0, 256.0, 300.0 } }, { { 256.0, 256.0, 0.0 } });
  scene.GetCamera()->SetViewUp(0.0, 1.0, 0.0);
  scene.GetCamera()->ParallelProjectionOn();
  scene.GetCamera()->SetParallelScale(parallelScale);
  scene.Renderer->ResetCameraClippingRange();
}

// On a plane, heights of triangles are those of the tiles.
void TestHeightColors(RelevoCheck& check, RelevoComparison& comparison)
{
  RelevoTerrainScene scene(
    513, 513, [](int column, int row) { return 0.0625f * (column - 256) + 0.03125f * row; });
  scene.Look({ { -80.0, 600.0, 120.0 } }, { { 250.0, 250.0, 0.0 } });
  scene.GetProperty()->LightingOff();
  vtkNew<vtkLookupTable> table;
  table->SetNumberOfTableValues(12);
  table->SetRange(-15.0, 20.0);
  table->Build();
  table->SetUseBelowRangeColor(1);
  table->SetBelowRangeColor(0.5, 0.2, 0.9, 1.0);
  scene.Mapper->Settings.Coloring = TerrainColoring::ELEVATION;
  scene.Mapper->Settings.Table = table;
  const RelevoPicture picture = scene.Draw();
  CHECK_EQUAL(scene.Mapper->Painter->GetColorError(), "");
  picture.Save(comparison.GetFolder() + "/TerrainPainter.Height.png");
  comparison.Compare("TerrainPainter.Height", { 2, 2e-6, 12 }, picture, scene.DrawTwin(table));
  table->SetRange(1.0, std::numeric_limits<double>::infinity());
  scene.Draw();
  CHECK(scene.Mapper->Painter->GetColorError().find("not finite") != std::string::npos);
}

// A plane that rises by `east` and `north` per world unit, before exaggeration.
class Plane
{
public:
  Plane(double east, double north, double exaggeration)
    : East(east)
    , North(north)
    , Scene(513, 513,
        [=](int column, int row)
        {
          const double x = 0.4 * (column - 256) + 0.3 * (row - 256);
          const double y = 0.3 * (column - 256) - 0.4 * (row - 256);
          return static_cast<float>(east * x + north * y);
        })
  {
    relevo::TerrainPainter::Settings& settings = this->Scene.Mapper->Settings;
    settings.Placement.Column = { { 0.4, 0.3 } };
    settings.Placement.Row = { { 0.3, -0.4 } };
    settings.Placement.HeightScale = exaggeration;
    settings.Exaggeration = exaggeration;
    LookFromAbove(this->Scene, 40.0);
  }

  // The only colour of the picture, or all 0.
  std::array<int, 3> Draw()
  {
    const RelevoPicture picture = this->Scene.Draw();
    const unsigned char* first = picture.Colors.data();
    for (size_t i = 0; i < picture.Colors.size(); ++i)
    {
      if (std::abs(picture.Colors[i] - first[i % 3]) > 1)
      {
        return { { 0, 0, 0 } };
      }
    }
    return { { first[0], first[1], first[2] } };
  }

  const double East;
  const double North;
  RelevoTerrainScene Scene;
};

// Checks a colour of a table from black to white over a range.
void CheckTable(RelevoCheck& check, Plane& plane, double value, double low, double high)
{
  vtkNew<vtkLookupTable> table;
  table->SetNumberOfTableValues(4096);
  table->SetHueRange(0.0, 0.0);
  table->SetSaturationRange(0.0, 0.0);
  table->SetValueRange(0.0, 1.0);
  table->SetRampToLinear();
  table->SetRange(low, high);
  table->Build();
  plane.Scene.Mapper->Settings.Table = table;
  plane.Scene.GetProperty()->LightingOff();
  const int expected = static_cast<int>(std::round(255.0 * (value - low) / (high - low)));
  CHECK_LESS_EQUAL(std::abs(plane.Draw()[1] - expected), 1);
}

void TestSlopes(RelevoCheck& check)
{
  const double slopes[][2] = { { 0.4, 0.0 }, { -0.3, 0.5 }, { 0.1, -0.9 }, { -0.2, -0.1 } };
  for (const auto& slope : slopes)
  {
    for (double exaggeration : { 1.0, 3.0 })
    {
      CHECK_CASE(slope[0]);
      CHECK_CASE(exaggeration);
      Plane plane(slope[0], slope[1], exaggeration);
      const double steepness = std::hypot(slope[0], slope[1]);
      // The normal of the surface that is drawn; the headlight shines from above.
      CHECK_LESS_EQUAL(
        std::abs(plane.Draw()[0] - 255.0 / std::hypot(1.0, exaggeration * steepness)), 1.5);
      plane.Scene.Mapper->Settings.Coloring = TerrainColoring::SLOPE;
      CheckTable(check, plane, vtkMath::DegreesFromRadians(std::atan(steepness)), 0.0, 90.0);
      plane.Scene.Mapper->Settings.Coloring = TerrainColoring::ASPECT;
      const double aspect = vtkMath::DegreesFromRadians(std::atan2(-slope[0], -slope[1]));
      CheckTable(check, plane, aspect < 0.0 ? aspect + 360.0 : aspect, 0.0, 360.0);
      plane.Scene.GetProperty()->LightingOn(); // has no effect
      plane.Scene.Mapper->Settings.Coloring = TerrainColoring::HILLSHADE;
      const double light = (0.5 * slope[0] - 0.5 * slope[1] + std::sqrt(0.5)) /
        std::sqrt(slope[0] * slope[0] + slope[1] * slope[1] + 1.0);
      CHECK_LESS_EQUAL(std::abs(plane.Draw()[2] - 255.0 * std::max(0.0, light)), 1.5);
    }
  }
  // Flat parts have no aspect.
  Plane plane(0.0, 0.0, 1.0);
  plane.Scene.Mapper->Settings.Coloring = TerrainColoring::ASPECT;
  vtkNew<vtkLookupTable> table;
  table->SetNanColor(0.2, 0.4, 0.6, 1.0);
  plane.Scene.Mapper->Settings.Table = table;
  plane.Scene.GetProperty()->LightingOff();
  CHECK_EQUAL(plane.Draw()[0], 51);
  CHECK_EQUAL(plane.Draw()[2], 153);
}

// Large faces have the shading of the tiles that match their pixels. A tile fades in.
void TestShading(RelevoCheck& check, RelevoComparison& comparison)
{
  const auto ripples = [](int column, int)
  { return column % 8 < 4 ? 0.3f * (column % 8) : 0.3f * (8 - column % 8); };
  RelevoTerrainScene scene(513, 513, ripples);
  scene.Mapper->Tolerance = 1000.0;
  LookFromAbove(scene, 60.0);
  RelevoTerrainRaster fine(513, 513, ripples);
  float visibility = 1.0f;
  const relevo::HeightTile* tiles[4];
  for (int i = 0; i < 4; ++i)
  {
    tiles[i] = fine.Get(0, i % 2, i / 2, 0.0, visibility);
  }
  const auto draw = [&](float share)
  {
    scene.Mapper->Shading.clear();
    for (const relevo::HeightTile* tile : tiles)
    {
      scene.Mapper->Shading.push_back({ tile, share });
    }
    return scene.Draw();
  };
  const RelevoPicture flat = scene.Draw();
  CHECK_EQUAL(scene.Mapper->Error, "");
  const RelevoPicture none = draw(0.0f);
  const RelevoPicture half = draw(0.5f);
  const RelevoPicture full = draw(1.0f);
  full.Save(comparison.GetFolder() + "/TerrainPainter.Shading.png");
  CHECK(none.Colors == flat.Colors);
  // The ripples have a slope of 0.3 nearly everywhere; half of it is 0.15.
  const auto count = [](const RelevoPicture& picture, double slope)
  {
    const double expected = 255.0 / std::hypot(1.0, slope);
    return std::count_if(picture.Colors.begin(), picture.Colors.end(),
      [expected](unsigned char color) { return std::abs(color - expected) <= 1.5; });
  };
  const double all = 3.0 * static_cast<double>(full.GetNumberOfPixels());
  CHECK_EQUAL(count(flat, 0.0), all);
  CHECK_GREATER(count(full, 0.3) / all, 0.4);
  CHECK_GREATER(count(half, 0.15) / all, 0.4);
  CHECK(full.Depths == flat.Depths);
}

// Triangles that are about as large as pixels have the same shading as others. A program for them
// is built when they appear.
void TestSmallTriangles(RelevoCheck& check)
{
  RelevoTerrainScene scene(
    513, 513, [](int column, int) { return 0.15f * (column - 256); }, 10.0f);
  const double exaggeration = 3.0;
  scene.Mapper->Settings.Placement.HeightScale = exaggeration;
  scene.Mapper->Settings.Exaggeration = exaggeration;
  LookFromAbove(scene, 150.0);
  const double expected = 255.0 / std::hypot(1.0, 0.15 * exaggeration);
  vtkIdType programs = 0;
  for (double tolerance : { 1000.0, 1.0 })
  {
    CHECK_CASE(tolerance);
    scene.Mapper->Tolerance = tolerance;
    const RelevoPicture picture = scene.Draw();
    CHECK_EQUAL(scene.Mapper->Painter->GetShaderError(), "");
    const auto wrong = std::count_if(picture.Colors.begin(), picture.Colors.end(),
      [expected](unsigned char color) { return std::abs(color - expected) > 1.5; });
    CHECK_EQUAL(wrong, 0);
    CHECK_EQUAL(scene.Mapper->Painter->GetNumberOfDrawCalls(), 2);
    ++programs;
    CHECK_EQUAL(scene.Mapper->Painter->GetNumberOfShaderBuilds(), programs);
  }
}

// On a plane that rises eastwards, contour lines are columns of pixels.
void TestContours(RelevoCheck& check, RelevoComparison& comparison)
{
  RelevoTerrainScene scene(513, 513, [](int column, int) { return 0.1f * column; });
  scene.GetProperty()->LightingOff();
  relevo::TerrainPainter::Settings& settings = scene.Mapper->Settings;
  settings.ContourInterval = 2.0;
  settings.ContourColor = { { 1.0, 0.0, 0.0 } };
  for (double parallelScale : { 30.0, 75.0 })
  {
    for (double width : { 1.0, 2.0, 5.0 })
    {
      CHECK_CASE(parallelScale);
      CHECK_CASE(width);
      settings.ContourWidth = width;
      LookFromAbove(scene, parallelScale);
      const RelevoPicture picture = scene.Draw();
      const double samplesPerPixel = 2.0 * parallelScale / 300.0;
      const double lines = 400.0 * samplesPerPixel / 20.0;
      double covered = 0.0;
      for (int x = 0; x < 400; ++x)
      {
        const double column = 256.0 + (x + 0.5 - 200.0) * samplesPerPixel;
        const double away =
          std::abs(column / 20.0 - std::round(column / 20.0)) * 20.0 / samplesPerPixel;
        const double coverage = std::clamp(0.5 * width + 0.5 - away, 0.0, std::min(width, 1.0));
        const size_t pixel = 3 * (static_cast<size_t>(150) * 400 + x);
        CHECK_EQUAL(picture.Colors[pixel], 255);
        CHECK_LESS_EQUAL(std::abs(picture.Colors[pixel + 1] - 255.0 * (1.0 - coverage)), 3.0);
        covered += 1.0 - picture.Colors[pixel + 1] / 255.0;
      }
      CHECK_NEAR(covered / lines, width, 0.05);
    }
  }
  RelevoTerrainScene hills;
  hills.Look({ { -80.0, 600.0, 120.0 } }, { { 250.0, 250.0, 0.0 } });
  hills.Mapper->Settings.Coloring = TerrainColoring::HILLSHADE;
  hills.Draw().Save(comparison.GetFolder() + "/TerrainPainter.Hillshade.png");
  hills.Mapper->Settings.ContourInterval = 4.0;
  hills.Mapper->Settings.ContourColor = { { 0.6, 0.3, 0.0 } };
  const RelevoPicture lines = hills.Draw();
  lines.Save(comparison.GetFolder() + "/TerrainPainter.Contours.png");
  // Contour lines separate the intervals of a table of the same heights.
  vtkNew<vtkLookupTable> table;
  table->SetNumberOfTableValues(20);
  table->SetRange(-40.0, 40.0);
  table->Build();
  for (int i = 0; i < 20; ++i)
  {
    table->SetTableValue(i, i % 2 == 0 ? 1.0 : 0.0, 0.0, 1.0);
  }
  hills.GetProperty()->LightingOff();
  hills.Mapper->Settings.Coloring = TerrainColoring::ELEVATION;
  hills.Mapper->Settings.Table = table;
  hills.Mapper->Settings.ContourWidth = 3.0;
  hills.Mapper->Settings.ContourColor = { { 0.0, 1.0, 0.0 } };
  const RelevoPicture both = hills.Draw();
  both.Save(comparison.GetFolder() + "/TerrainPainter.Intervals.png");
  size_t borders = 0;
  for (size_t i = 0; i + 1 < both.GetNumberOfPixels(); ++i)
  {
    const unsigned char* here = &both.Colors[3 * i];
    const unsigned char* next = here + 3;
    const bool isLine = here[1] > 0 || next[1] > 0;
    const bool isTerrain = here[2] > 0 && next[2] > 0;
    borders += isTerrain && !isLine && here[0] != next[0] ? 1 : 0;
  }
  // Silhouettes hide some lines.
  CHECK_LESS(borders, 150);
}
}

int TestTerrainPainterColors(int argc, char* argv[])
{
  RelevoCheck check;
  RelevoComparison comparison(check, argc, argv);
  TestHeightColors(check, comparison);
  TestSlopes(check);
  TestShading(check, comparison);
  TestSmallTriangles(check);
  TestContours(check, comparison);
  return check.GetResult();
}
