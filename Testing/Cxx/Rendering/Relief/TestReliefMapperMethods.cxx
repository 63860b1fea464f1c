// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves reliefs.md: all methods and searches of vtkReliefMapper agree with rays in double
// precision, in moderate views.
#include "RelevoCheck.h"
#include "RelevoDice.h"
#include "RelevoReliefScene.h"

#include "vtkCamera.h"
#include "vtkImageData.h"

#include <cmath>
#include <iostream>

namespace
{
using relevo::ReliefProjection;

struct Policy
{
  int Method;
  int Search;
  double ShareHit;   // smallest share of the pixels that rays hit
  double ShareRight; // smallest share of the hits within half a texel
};

void TestWay(RelevoCheck& check, vtkImageData* relief, const Policy& way)
{
  RelevoReliefScene scene(relief, 120, 90);
  RelevoErrors errors(scene.Mapper);
  scene.Mapper->SetMethod(way.Method);
  scene.Mapper->SetSearch(way.Search);
  for (double azimuth : { -30.0, 0.0, 40.0 })
  {
    CHECK_CASE(azimuth);
    scene.ResetCamera();
    scene.GetCamera()->Azimuth(azimuth);
    scene.Renderer->ResetCameraClippingRange();
    const RelevoReliefComparison result = scene.Compare(relief);
    std::cout << "method " << way.Method << ", search " << way.Search << ", azimuth " << azimuth
              << ": " << result.NumberOfHits << " hits, " << result.NumberOfMisses << " missed, "
              << result.NumberOfWrong << " wrong, " << result.NumberFar << " far\n";
    CHECK_GREATER(result.NumberOfHits, 500);
    CHECK_LESS_EQUAL(result.NumberOfMisses, (1.0 - way.ShareHit) * result.NumberOfHits);
    CHECK_GREATER_EQUAL(result.GetShareRight(), way.ShareRight);
  }
  CHECK(errors.None());
}

// The hills are low, so that few points leave the picture on the plane.
void TestWarp(RelevoCheck& check, ReliefProjection projection)
{
  const bool isPerspective = projection == ReliefProjection::Perspective;
  const auto relief = RelevoMakeRelief(48, 40, projection,
    isPerspective ? RelevoPinhole(48, 40, 0.025) : RelevoSmallTexels(),
    [isPerspective](int column, int row)
    { return (isPerspective ? 10.0 : 1.0) + 0.1 * RelevoHillsWithHoles(column, row); });
  RelevoReliefScene scene(relief, 120, 90);
  scene.Mapper->SetMethodToWarp();
  for (double azimuth : { -5.0, 0.0, 10.0 })
  {
    scene.LookStraight();
    scene.GetCamera()->Azimuth(azimuth);
    scene.Renderer->ResetCameraClippingRange();
    const RelevoReliefComparison result = scene.Compare(relief, 8.0, 1.0);
    std::cout << "warp, azimuth " << azimuth << ": " << result.NumberOfHits << " hits, "
              << result.NumberOfMisses << " missed, " << result.NumberOfWrong << " wrong\n";
    CHECK_EQUAL(scene.Mapper->GetMethodInUse(), vtkReliefMapper::METHOD_WARP);
    CHECK_GREATER(result.NumberOfHits, 500);
    CHECK_LESS_EQUAL(result.NumberOfMisses, 0.1 * result.NumberOfHits); // half a texel at borders
    CHECK_GREATER_EQUAL(result.GetShareRight(), 0.98);
  }
  // No eye has moved.
  CHECK_EQUAL(scene.Mapper->GetNumberOfWarps(), 3);
  scene.GetCamera()->Zoom(1.1);
  scene.Window->Render();
  CHECK_EQUAL(scene.Mapper->GetNumberOfWarps(), 3);
  // Seen from behind, no warped picture exists.
  scene.GetCamera()->Azimuth(180.0);
  scene.Renderer->ResetCameraClippingRange();
  CHECK(scene.Compare(relief).IsRight());
  CHECK_EQUAL(scene.Mapper->GetMethodInUse(), vtkReliefMapper::METHOD_RAY_MARCH);
}

// Reliefs and window size choose the method, not measured times, so all frames are equal, bit for
// bit.
void TestAutomatic(RelevoCheck& check, vtkImageData* relief, int width, int method)
{
  RelevoReliefScene scene(relief, width, 3 * width / 4);
  CHECK_EQUAL(scene.Mapper->GetMethod(), vtkReliefMapper::METHOD_AUTOMATIC);
  scene.Window->Render();
  const RelevoPicture first(scene.Window);
  CHECK_GREATER(first.CountForeground(), 100);
  for (int i = 0; i < 12; ++i)
  {
    scene.GetCamera()->Azimuth(i == 5 ? 20.0 : i == 6 ? -20.0 : 0.0);
    scene.Window->Render();
    CHECK_EQUAL(scene.Mapper->GetMethodInUse(), method);
  }
  CHECK_EQUAL(scene.Mapper->GetNumberOfShaderBuilds(), 1);
  RelevoReliefScene other(relief, width, 3 * width / 4);
  for (RelevoReliefScene* each : { &scene, &other })
  {
    each->ResetCamera();
    each->Window->Render();
    const RelevoPicture picture(each->Window);
    CHECK_EQUAL(picture.Colors, first.Colors);
    CHECK_EQUAL(picture.Depths, first.Depths);
  }
  CHECK_GREATER_EQUAL(scene.Compare(relief).GetShareRight(), 0.998);
}

// In a valley between bumps that rays graze. Cone stepping must not skip them.
void TestValley(RelevoCheck& check)
{
  const auto relief = RelevoMakeRelief(97, 97, ReliefProjection::Parallel, relevo::dmat4(1.0),
    [](int column, int row)
    {
      const double side = std::abs(column - 48.0) / 48.0;
      return -15.0 * side * side + 1.2 * std::sin(0.61 * column + 0.3 * row) * std::sin(0.47 * row);
    });
  RelevoReliefScene scene(relief, 160, 120);
  scene.Mapper->SetMethodToRayMarch();
  scene.Mapper->SetSearchToRelaxedCones();
  vtkCamera* camera = scene.GetCamera();
  camera->SetViewUp(0.0, 0.0, -1.0);
  for (double eye : { -3.0, -5.0, -12.0 })
  {
    CHECK_CASE(eye);
    camera->SetPosition(48.0, 4.0, eye);
    camera->SetFocalPoint(48.0, 97.0, 0.0);
    camera->SetClippingRange(0.5, 300.0);
    const RelevoReliefComparison result = scene.Compare(relief);
    std::cout << "cones in a valley, eye at " << eye << ": " << result.NumberOfHits << " hits, "
              << result.NumberOfMisses << " missed, " << result.NumberOfWrong << " wrong\n";
    CHECK_GREATER(result.NumberOfHits, 5000);
    CHECK_LESS_EQUAL(result.NumberOfMisses + result.NumberOfWrong, 0.01 * result.NumberOfHits);
  }
}

// Ray casting and patterns share little code, and agree in every view, including from inside and
// behind.
void TestAgreement(RelevoCheck& check, vtkImageData* relief)
{
  RelevoReliefScene scene(relief, 120, 90);
  RelevoDice dice(15);
  const double* bounds = scene.Actor->GetBounds();
  const double size = scene.Actor->GetLength();
  int number = 0;
  int different = 0;
  for (int i = 0; i < 20; ++i)
  {
    double eye[3];
    double focus[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      const double middle = 0.5 * (bounds[2 * axis] + bounds[2 * axis + 1]);
      eye[axis] = middle + size * dice.Signed();
      focus[axis] = middle + 0.3 * size * dice.Signed();
    }
    scene.GetCamera()->SetPosition(eye);
    scene.GetCamera()->SetFocalPoint(focus);
    scene.GetCamera()->SetParallelProjection(i % 4 == 0);
    scene.GetCamera()->SetParallelScale(0.3 * size);
    scene.Renderer->ResetCameraClippingRange();
    scene.Mapper->SetMethodToRayMarch();
    const std::vector<float> marched = scene.DrawDepths();
    scene.Mapper->SetMethodToRefinement();
    const std::vector<float> refined = scene.DrawDepths();
    for (size_t pixel = 0; pixel < marched.size(); ++pixel)
    {
      number += marched[pixel] < 1.0f ? 1 : 0;
      different += (marched[pixel] < 1.0f) != (refined[pixel] < 1.0f) ? 1 : 0;
    }
  }
  std::cout << different << " of " << number << " pixels differ by method\n";
  CHECK_GREATER(number, 20000);
  CHECK_LESS_EQUAL(different, number / 500);
}

// 10 bytes per texel with colour and depth, and few for texels without.
void TestMemory(RelevoCheck& check)
{
  const auto relief = RelevoMakeRelief(400, 400, ReliefProjection::Parallel, RelevoSmallTexels(),
    [](int column, int row) {
      return std::hypot(column - 200, row - 200) < 150.0 ? RelevoHills(column, row) : std::nan("");
    });
  RelevoReliefScene scene(relief, 120, 90);
  scene.Mapper->SetMethodToRayMarch();
  scene.Window->Render();
  const double valid = 3.14159 * 150.0 * 150.0;
  CHECK_GREATER(scene.Mapper->GetGraphicsMemorySize(), 8.0 * valid);
  CHECK_LESS(scene.Mapper->GetGraphicsMemorySize(), 13.0 * valid);
}
}

int TestReliefMapperMethods(int, char*[])
{
  RelevoCheck check;
  const auto parallel =
    RelevoMakeRelief(48, 40, ReliefProjection::Parallel, RelevoSmallTexels(), RelevoHillsWithHoles);
  const auto perspective =
    RelevoMakeRelief(48, 40, ReliefProjection::Perspective, RelevoPinhole(48, 40, 0.025),
      [](int column, int row) { return 0.5 * RelevoHillsWithHoles(column, row); });
  using Mapper = vtkReliefMapper;
  for (const auto& relief : { parallel, perspective })
  {
    TestWay(check, relief, { Mapper::METHOD_REFINEMENT, 3, 0.998, 0.998 });
    TestWay(check, relief, { Mapper::METHOD_RAY_MARCH, Mapper::SEARCH_LINEAR_BINARY, 0.98, 0.98 });
    TestWay(check, relief, { Mapper::METHOD_RAY_MARCH, Mapper::SEARCH_LINEAR_SECANT, 0.98, 0.98 });
    TestWay(check, relief, { Mapper::METHOD_RAY_MARCH, Mapper::SEARCH_RELAXED_CONES, 0.98, 0.98 });
    TestAutomatic(check, relief, 120, Mapper::METHOD_RAY_MARCH);
    TestAutomatic(check, relief, 240, Mapper::METHOD_RAY_MARCH);
    TestAgreement(check, relief);
  }
  // This relief has no openings, and at most 32 x 32 x 2 triangles.
  const auto closed =
    RelevoMakeRelief(33, 33, ReliefProjection::Parallel, RelevoSmallTexels(), RelevoHills);
  TestAutomatic(check, closed, 120, Mapper::METHOD_REFINEMENT);
  const auto rough = RelevoMakeRelief(33, 33, ReliefProjection::Parallel, RelevoSmallTexels(),
    [](int column, int row) { return 0.3 * ((column + row) % 2); });
  TestAutomatic(check, rough, 120, Mapper::METHOD_REFINEMENT);
  TestAutomatic(check, rough, 32, Mapper::METHOD_RAY_MARCH);
  TestValley(check);
  TestMemory(check);
  TestWarp(check, ReliefProjection::Parallel);
  TestWarp(check, ReliefProjection::Perspective);
  return check.GetResult();
}
