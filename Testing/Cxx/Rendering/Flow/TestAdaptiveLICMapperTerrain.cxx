// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkAdaptiveLICMapper promises: vectors follow the displaced surface, and there are no streaks
// over holes. The test uses wind over terrain.
#include "RelevoDisplacements.h"
#include "RelevoSurfaceFields.h"

#include <iostream>

namespace
{
constexpr int Width = 480;
constexpr int Height = 360;
constexpr double Relief = 0.06;
using Vector = std::array<double, 3>;

// Heights over the square [-0.5, 0.5]^2.
double HeightAt(double u, double v)
{
  return std::sin(2.0 * vtkMath::Pi() * u + 0.4) * std::cos(3.0 * vtkMath::Pi() * v);
}

Vector NormalOfTerrain(const Vector& p)
{
  const double step = 1e-5;
  const double u = p[0] + 0.5;
  const double v = p[1] + 0.5;
  Vector normal{ { 0.5 * Relief * (HeightAt(u - step, v) - HeightAt(u + step, v)) / step,
    0.5 * Relief * (HeightAt(u, v - step) - HeightAt(u, v + step)) / step, 1.0 } };
  vtkMath::Normalize(normal.data());
  return normal;
}

Vector NormalOfPlane(const Vector&)
{
  return { { 0.0, 0.0, 1.0 } };
}

Vector Wind(const Vector& p)
{
  return { { 1.0, 0.5 - p[0], 0.0 } };
}

void TestSlopes(RelevoCheck& check)
{
  vtkNew<RelevoHeights> heights;
  heights->Fill(256, 256, HeightAt);
  auto displacement = RelevoMeshes::MakeDisplacement(heights, Relief);
  RelevoLICScene scene(Width, Height);
  scene.Add(WithField(RelevoMeshes::Plane(16, 16), Wind),
    RelevoMeshes::MakeRecipe(4, nullptr, displacement));
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->SetPosition(0.5, -0.8, 0.8);
  camera->SetFocalPoint(0.0, -0.05, 0.0);
  camera->SetViewUp(0.0, 0.0, 1.0);
  camera->SetViewAngle(45.0);
  scene.Renderer->ResetCameraClippingRange();
  const RelevoLICPicture picture = scene.Render();
  const auto measure = [&](const RelevoSurfaceField& normal)
  { return MeasureStreaks(picture, scene.Renderer, TangentOf(Wind, normal), normal); };
  const RelevoDeviations deviations = measure(NormalOfTerrain);
  std::cout << "slopes: " << deviations << "\n";
  CHECK_GREATER(deviations.Count, 15000);
  CHECK_LESS_EQUAL(deviations.Median, 1.5);
  CHECK_LESS_EQUAL(deviations.Percentile95, 5.0);
  // Negative control: with the normals of a flat plane, deviations are larger.
  const RelevoDeviations flat = measure(NormalOfPlane);
  std::cout << "with flat normals: " << flat << "\n";
  CHECK_GREATER(flat.Median, 4.0);
}

void TestHoles(RelevoCheck& check)
{
  vtkNew<RelevoHeights> heights;
  heights->FillWavesWithHoles();
  auto displacement = RelevoMeshes::MakeDisplacement(heights, Relief);
  RelevoLICScene scene(Width, Height);
  scene.Add(
    WithField(RelevoMeshes::Plane(8, 8), Wind), RelevoMeshes::MakeRecipe(4, nullptr, displacement));
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetParallelScale(0.5);
  camera->SetPosition(0.0, 0.0, 2.0);
  scene.Renderer->ResetCameraClippingRange();
  const RelevoLICPicture picture = scene.Render();
  int size[2];
  heights->GetDimensions(size);
  std::size_t holes = 0;
  for (int row = 0; row < Height; ++row)
  {
    for (int column = 0; column < Width; ++column)
    {
      // The position is in units of texels, relative to the first centre.
      const double x = size[0] * ((column + 0.5 - 0.5 * Width) / Height + 0.5) - 0.5;
      const double y = size[1] * ((row + 0.5) / Height) - 0.5;
      int near = 0;   // missing texels among the nearest four
      int around = 0; // missing texels among the nearest sixteen, where triangles end
      for (int i = 0; i < 16; ++i)
      {
        const int texelX = static_cast<int>(std::floor(x)) + i % 4 - 1;
        const int texelY = static_cast<int>(std::floor(y)) + i / 4 - 1;
        const bool inside = texelX >= 0 && texelY >= 0 && texelX < size[0] && texelY < size[1];
        const bool isHole = inside && !heights->GetValidity()[texelY * size[0] + texelX];
        const bool isNear = i % 4 % 3 != 0 && i / 4 % 3 != 0;
        around += isHole ? 1 : 0;
        near += isHole && isNear ? 1 : 0;
      }
      if (near == 4)
      {
        ++holes;
        CHECK(!picture.HasLIC(column, row));
        CHECK_EQUAL(picture.GetDepth(column, row), 1.0);
      }
      else if (around == 0 && x > 1.0 && x < size[0] - 2.0 && y > 1.0 && y < size[1] - 2.0)
      {
        CHECK(picture.HasLIC(column, row));
      }
    }
  }
  CHECK_GREATER(holes, 1000);
}
}

int TestAdaptiveLICMapperTerrain(int, char*[])
{
  RelevoCheck check;
  TestSlopes(check);
  TestHoles(check);
  return check.GetResult();
}
