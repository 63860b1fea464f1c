// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves that a volume has the same colours in every viewport, layer, tile and multisampled window.
#include "RelevoCheck.h"
#include "RelevoVolumeScene.h"

#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkWindowToImageFilter.h"

#include <algorithm>
#include <cmath>

namespace
{
constexpr int Width = 90;
constexpr int Height = 80;

std::vector<RelevoColor> DrawAlone()
{
  RelevoVolumeScene scene(MakeTetrahedra(3, GetLinearField), MakeLinearProperty(), Width, Height);
  return scene.Draw();
}

void TestMultiSamples(RelevoCheck& check)
{
  RelevoVolumeScene scene(MakeTetrahedra(3, GetLinearField), MakeLinearProperty(), Width, Height);
  scene.GetWindow()->SetMultiSamples(4);
  CHECK_LESS_EQUAL(FindLargestDifference(scene.Draw(), DrawAlone()), 1.0 / 255.0);
}

// The same volume in the right half of a window.
void TestViewports(RelevoCheck& check)
{
  const auto alone = DrawAlone();
  RelevoVolumeScene scene(
    MakeTetrahedra(3, GetLinearField), MakeLinearProperty(), 2 * Width, Height);
  vtkCamera* camera = scene.GetCamera();
  scene.GetRenderer()->SetViewport(0.0, 0.0, 0.5, 1.0);
  vtkNew<vtkRenderer> right;
  right->SetViewport(0.5, 0.0, 1.0, 1.0);
  right->SetActiveCamera(camera);
  right->AddVolume(scene.GetVolume());
  scene.GetWindow()->AddRenderer(right);
  const auto both = scene.Draw();
  double most = 0.0;
  for (int row = 0; row < Height; ++row)
  {
    for (int column = 0; column < 2 * Width; ++column)
    {
      for (int c = 0; c < 3; ++c)
      {
        most = std::max(most,
          std::abs(both[2 * Width * row + column][c] - alone[Width * row + column % Width][c]));
      }
    }
  }
  CHECK_NEAR(most, 0.0, 1.0 / 255.0);
}

// In front of a lower layer that is visible through it.
void TestLayers(RelevoCheck& check)
{
  const auto alone = DrawAlone();
  RelevoVolumeScene scene(MakeTetrahedra(3, GetLinearField), MakeLinearProperty(), Width, Height);
  vtkNew<vtkRenderer> below;
  below->SetBackground(0.2, 0.4, 0.6);
  scene.GetWindow()->SetNumberOfLayers(2);
  scene.GetWindow()->AddRenderer(below);
  scene.GetRenderer()->SetLayer(1);
  const auto over = scene.Draw();
  const auto cast = scene.Cast();
  const RelevoColor background = { { 0.2, 0.4, 0.6, 0.0 } };
  double most = 0.0;
  for (size_t i = 0; i < over.size(); ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      const double expected = alone[i][c] + (1.0 - cast[i][3]) * background[c];
      most = std::max(most, std::abs(over[i][c] - expected));
    }
  }
  CHECK_NEAR(most, 0.0, 2.0 / 255.0);
}

// A large picture in tiles.
void TestTiles(RelevoCheck& check)
{
  RelevoVolumeScene large(
    MakeTetrahedra(3, GetLinearField), MakeLinearProperty(), 2 * Width, 2 * Height);
  const auto whole = large.Draw();
  RelevoVolumeScene scene(MakeTetrahedra(3, GetLinearField), MakeLinearProperty(), Width, Height);
  scene.Draw();
  vtkNew<vtkWindowToImageFilter> capture;
  capture->SetInput(scene.GetWindow());
  capture->SetScale(2);
  capture->ReadFrontBufferOff();
  capture->Update();
  vtkDataArray* tiles = capture->GetOutput()->GetPointData()->GetScalars();
  CHECK_EQUAL(tiles->GetNumberOfTuples(), static_cast<vtkIdType>(whole.size()));
  double most = 0.0;
  for (size_t i = 0; i < whole.size(); ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      const double tile = tiles->GetComponent(static_cast<vtkIdType>(i), c) / 255.0;
      most = std::max(most, std::abs(tile - whole[i][c]));
    }
  }
  CHECK_NEAR(most, 0.0, 1.5 / 255.0);
}
}

int TestGPUUnstructuredGridVolumeMapperPlacement(int, char*[])
{
  RelevoCheck check;
  TestMultiSamples(check);
  TestViewports(check);
  TestLayers(check);
  TestTiles(check);
  return check.GetResult();
}
