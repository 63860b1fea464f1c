// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves volumes.md on sampling: how many rays are cast, and how often they enter the mesh.
#include "RelevoCheck.h"
#include "RelevoVolumeScene.h"

#include "vtkMultiBlockDataSet.h"

#include <cmath>

namespace
{
// Coarser pictures interpolate between fewer rays.
void TestDistances(RelevoCheck& check)
{
  RelevoVolumeScene scene(MakeTetrahedra(3, GetLinearField), MakeLinearProperty(), 120, 120);
  vtkGPUUnstructuredGridVolumeMapper* mapper = scene.GetMapper();
  const auto fine = scene.Draw();
  mapper->SetImageSampleDistance(2.0);
  const auto coarse = scene.Draw();
  CHECK_GREATER(FindLargestDifference(fine, coarse), 0.01); // on the silhouette
  CHECK_NEAR(FindLargestDifferenceInside(fine, coarse, 120, 55, 64), 0.0, 2.0 / 255.0);
  // There are as many rays as in a window of half the size.
  RelevoVolumeScene small(MakeTetrahedra(3, GetLinearField), MakeLinearProperty(), 60, 60);
  const auto half = small.Draw();
  double apart = 0.0;
  for (int row = 20; row < 40; ++row)
  {
    for (int column = 20; column < 40; ++column)
    {
      double mean = 0.0;
      for (int i = 0; i < 4; ++i)
      {
        mean += 0.25 * coarse[120 * (2 * row + i / 2) + 2 * column + i % 2][0];
      }
      apart = std::max(apart, std::abs(mean - half[60 * row + column][0]));
    }
  }
  CHECK_NEAR(apart, 0.0, 2.0 / 255.0);

  mapper->SetImageSampleDistance(0.5);
  const auto smooth = scene.Draw();
  CHECK_GREATER(FindLargestDifference(fine, smooth), 0.0);
  CHECK_LESS(FindLargestDifference(fine, smooth), 0.05);
  mapper->SetImageSampleDistance(1.0);
  CHECK_EQUAL(FindLargestDifference(fine, scene.Draw()), 0.0);
  RelevoErrors errors(mapper);
  mapper->SetImageSampleDistance(0.0);
  CHECK(errors.Said("ImageSampleDistance"));
  CHECK_EQUAL(mapper->GetImageSampleDistance(), 1.0);
}

// Without any time the sampling becomes as coarse as possible, with enough time as fine as
// possible.
void TestAdjusted(RelevoCheck& check)
{
  RelevoVolumeScene scene(MakeTetrahedra(3, GetLinearField), MakeLinearProperty(), 120, 120);
  const auto fine = scene.Draw();
  CHECK(scene.GetMapper()->GetAutoAdjustSampleDistances());
  scene.GetWindow()->SetDesiredUpdateRate(1e7);
  scene.Draw();
  CHECK_GREATER(FindLargestDifference(fine, scene.Draw()), 0.1);
  CHECK_GREATER(scene.GetMapper()->GetTimeToDraw(), 0.0);
  scene.GetWindow()->SetDesiredUpdateRate(1e-6);
  CHECK_EQUAL(FindLargestDifference(fine, scene.Draw()), 0.0);
  // Views without a rate do not move, however little time they have.
  scene.GetVolume()->SetAllocatedRenderTime(1e-7, scene.GetRenderer());
  CHECK_EQUAL(FindLargestDifference(fine, scene.Draw()), 0.0);
  scene.GetMapper()->AutoAdjustSampleDistancesOff();
  scene.GetWindow()->SetDesiredUpdateRate(1e7);
  CHECK_EQUAL(FindLargestDifference(fine, scene.Draw()), 0.0);
}

void TestLayers(RelevoCheck& check)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  for (int i = 0; i < 3; ++i)
  {
    const auto mesh = MakeTetrahedra(2, GetLinearField);
    for (vtkIdType point = 0; point < mesh->GetNumberOfPoints(); ++point)
    {
      double x[3];
      mesh->GetPoint(point, x);
      mesh->GetPoints()->SetPoint(point, x[0] + 2.0 * i, x[1], x[2]);
    }
    blocks->SetBlock(static_cast<unsigned int>(i), mesh);
  }
  RelevoVolumeScene scene(blocks, MakeLinearProperty(), 100, 100);
  CHECK_EQUAL(scene.GetMapper()->GetNumberOfLayers(), 0); // nothing drawn
  vtkCamera* camera = scene.GetCamera();
  camera->SetFocalPoint(2.5, 0.5, 0.5);
  camera->SetPosition(2.5, 0.5, 12.0);
  scene.GetRenderer()->ResetCameraClippingRange();
  scene.Draw();
  CHECK_EQUAL(scene.GetMapper()->GetNumberOfLayers(), 1);
  camera->SetPosition(14.0, 0.5, 0.5);
  scene.GetRenderer()->ResetCameraClippingRange();
  scene.Draw();
  CHECK_EQUAL(scene.GetMapper()->GetNumberOfLayers(), 3);
  // The camera is in the middle part and sees one part ahead.
  camera->SetPosition(2.5, 0.5, 0.5);
  camera->SetFocalPoint(14.0, 0.5, 0.5);
  camera->SetClippingRange(0.01, 20.0);
  scene.Draw();
  CHECK_EQUAL(scene.GetMapper()->GetNumberOfLayers(), 2);
}
}

int TestGPUUnstructuredGridVolumeMapperSampling(int, char*[])
{
  RelevoCheck check;
  TestDistances(check);
  TestAdjusted(check);
  TestLayers(check);
  return check.GetResult();
}
