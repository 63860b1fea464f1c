// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkReliefMapper promises the relief's surface from every view, compared with rays in double
// precision: covered pixels, positions and depths.
#include "RelevoCheck.h"
#include "RelevoReliefScene.h"

#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <iostream>

namespace
{
using relevo::ReliefProjection;

vtkSmartPointer<vtkImageData> MakeParallel()
{
  return RelevoMakeRelief(
    48, 40, ReliefProjection::Parallel, RelevoSmallTexels(), RelevoHillsWithHoles);
}

vtkSmartPointer<vtkImageData> MakePerspective()
{
  return RelevoMakeRelief(48, 40, ReliefProjection::Perspective, RelevoPinhole(48, 40, 0.025),
    [](int column, int row) { return 0.5 * RelevoHillsWithHoles(column, row); });
}

void TestViews(RelevoCheck& check, vtkImageData* relief)
{
  RelevoReliefScene scene(relief, 120, 90);
  scene.Mapper->SetMethodToRayMarch();
  for (bool parallel : { false, true })
  {
    CHECK_CASE(parallel);
    scene.GetCamera()->SetParallelProjection(parallel);
    for (double azimuth : { 0.0, 30.0, 85.0, 180.0 })
    {
      CHECK_CASE(azimuth);
      scene.ResetCamera();
      scene.GetCamera()->Azimuth(azimuth);
      scene.Renderer->ResetCameraClippingRange();
      const RelevoReliefComparison result = scene.Compare(relief);
      std::cout << "parallel " << parallel << ", azimuth " << azimuth << ": " << result.NumberOfHits
                << " hits, " << result.NumberOfMisses << " missed, " << result.NumberOfWrong
                << " wrong, " << result.NumberFar << " far\n";
      CHECK_GREATER(result.NumberOfHits, 500);
      CHECK(result.IsRight());
      CHECK_LESS_EQUAL(result.NumberFar, 2);
    }
  }
}

// A camera in front of the surface's centre looks along the surface.
void TestInside(RelevoCheck& check, vtkImageData* relief)
{
  RelevoReliefScene scene(relief, 120, 90);
  scene.Mapper->SetMethodToRayMarch();
  double center[3];
  std::copy_n(scene.Actor->GetCenter(), 3, center);
  vtkCamera* camera = scene.GetCamera();
  camera->SetPosition(center);
  for (double angle : { 0.0, 90.0, 180.0, 270.0 })
  {
    CHECK_CASE(angle);
    const double radians = vtkMath::RadiansFromDegrees(angle);
    camera->SetFocalPoint(
      center[0] + std::cos(radians), center[1] + 0.1, center[2] + std::sin(radians));
    camera->SetClippingRange(0.01, 20.0);
    const RelevoReliefComparison result = scene.Compare(relief);
    std::cout << "inside, " << angle << ": " << result.NumberOfHits << " hits, "
              << result.NumberOfMisses << " missed, " << result.NumberOfWrong << " wrong\n";
    CHECK(result.IsRight());
  }
}

// Actor matrices with translation, rotation, unequal scales and mirroring.
void TestActorMatrix(RelevoCheck& check, vtkImageData* relief)
{
  RelevoReliefScene scene(relief, 120, 90);
  scene.Mapper->SetMethodToRayMarch();
  scene.Actor->SetScale(1.0, -2.0, 0.5);
  scene.Actor->RotateWXYZ(40.0, 1.0, 2.0, 3.0);
  scene.Actor->SetPosition(100.0, -20.0, 3.0);
  scene.ResetCamera();
  const RelevoReliefComparison result = scene.Compare(relief);
  std::cout << "matrix: " << result.NumberOfHits << " hits, " << result.NumberOfMisses
            << " missed, " << result.NumberOfWrong << " wrong\n";
  CHECK_GREATER(result.NumberOfHits, 500);
  CHECK(result.IsRight());
}

// A moving camera uploads nothing and builds no shader.
void TestBuilds(RelevoCheck& check, vtkImageData* relief)
{
  RelevoReliefScene scene(relief, 120, 90);
  scene.Mapper->SetMethodToRayMarch();
  scene.Window->Render();
  const vtkIdType buffers = scene.Mapper->GetNumberOfBufferBuilds();
  const vtkIdType shaders = scene.Mapper->GetNumberOfShaderBuilds();
  CHECK_EQUAL(buffers, 1);
  CHECK_EQUAL(shaders, 1);
  scene.GetCamera()->Azimuth(10.0);
  scene.Window->Render();
  CHECK_EQUAL(scene.Mapper->GetNumberOfBufferBuilds(), buffers);
  CHECK_EQUAL(scene.Mapper->GetNumberOfShaderBuilds(), shaders);
  scene.Mapper->SetMaximumStretch(2.0);
  const RelevoReliefComparison result = scene.Compare(relief, 2.0);
  std::cout << "stretch 2: " << result.NumberOfHits << " hits, " << result.NumberOfMisses
            << " missed, " << result.NumberOfWrong << " wrong\n";
  CHECK(result.IsRight());
  CHECK_EQUAL(scene.Mapper->GetNumberOfBufferBuilds(), buffers + 1);
  CHECK_GREATER(scene.Mapper->GetGraphicsMemorySize(), 8 * 2000);
}
}

int TestReliefMapper(int, char*[])
{
  RelevoCheck check;
  for (const auto& relief : { MakeParallel(), MakePerspective() })
  {
    TestViews(check, relief);
    TestInside(check, relief);
    TestActorMatrix(check, relief);
    TestBuilds(check, relief);
  }
  return check.GetResult();
}
