// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkReliefWarper promises an error for input that it cannot warp and for eyes without a picture.
// Numbers of any size are handled.
#include "RelevoBlocks.h"
#include "RelevoCheck.h"
#include "RelevoDice.h"
#include "RelevoWarnings.h"
#include "RelevoWarpScenes.h"
#include "vtkReliefWarper.h"

#include "vtkDataArray.h"
#include "vtkExecutive.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <cmath>
#include <limits>

namespace
{
using relevo::ReliefProjection;

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinity = std::numeric_limits<double>::infinity();
constexpr int Width = 17;
constexpr int Height = 13;

int CountSeen(vtkImageData* image)
{
  vtkDataArray* depths = image->GetPointData()->GetArray("Depth");
  int seen = 0;
  for (vtkIdType i = 0; i < depths->GetNumberOfTuples(); ++i)
  {
    seen += depths->GetComponent(i, 0) == depths->GetComponent(i, 0);
  }
  return seen;
}

vtkSmartPointer<vtkImageData> MakeSlanted(ReliefProjection projection)
{
  return RelevoMakeWarpRelief(RelevoMakeWarpScenes(Width, Height)[1], Width, Height, projection);
}

void TestErrors(RelevoCheck& check)
{
  vtkNew<vtkReliefWarper> warper;
  RelevoErrors errors(warper);
  RelevoErrors ofExecutive(warper->GetExecutive());
  const auto image = MakeSlanted(ReliefProjection::Parallel);
  warper->SetInputData(image);
  warper->Update();
  CHECK(errors.Said("no camera"));
  CHECK(!warper->CanWarp() && warper->GetState() == vtkReliefWarper::INITIAL);
  warper->SetCamera(
    RelevoMakeWarpCamera(Width, Height, ReliefProjection::Parallel, false, 0.0, 0.0));
  for (int policy : { vtkReliefWarper::SEQUENTIAL, vtkReliefWarper::PARALLEL })
  {
    CHECK_CASE(policy);
    warper->SetPolicy(policy);
    warper->SetInputData(image);
    warper->Update();
    CHECK(errors.None() && CountSeen(warper->GetOutput()) > 0);
    const auto empty = RelevoMakeRelief(
      Width, Height, ReliefProjection::Parallel, relevo::dmat4(1.0), [](int, int) { return NaN; });
    warper->SetInputData(empty);
    warper->Update();
    CHECK(errors.Said("The input is not a relief. No value of the point array 'Depth' is finite."));
    CHECK_EQUAL(warper->GetOutput()->GetNumberOfPoints(), 0);
    CHECK_EQUAL(warper->GetState(), vtkReliefWarper::INITIAL);
    const auto singular = MakeSlanted(ReliefProjection::Parallel);
    singular->GetFieldData()->GetArray("ReliefMatrix")->SetComponent(5, 0, 0.0);
    warper->SetInputData(singular);
    warper->Update();
    CHECK(errors.Said("is a singular matrix"));
    warper->SetInputData(vtkNew<vtkImageData>());
    warper->Update();
    CHECK(errors.Said("0 x 0 x 0") || errors.Said("no relief"));
  }
  warper->SetInputData(image);
  warper->Update();
  CHECK(errors.None() && CountSeen(warper->GetOutput()) > 0);
  CHECK(RelevoRefusesBlock(
    warper, 0, vtkNew<vtkPolyData>(), "The input is a vtkPolyData; a vtkImageData is needed."));
}

// An eye in the plane or behind it has no picture. In front of the plane, warping works again.
void TestEyes(RelevoCheck& check)
{
  for (ReliefProjection projection : { ReliefProjection::Parallel, ReliefProjection::Perspective })
  {
    const double plane = projection == ReliefProjection::Parallel ? 0.0 : 60.0;
    for (bool isParallel : { false, true })
    {
      vtkNew<vtkReliefWarper> warper;
      RelevoWarnings warnings(warper);
      warper->SetInputData(MakeSlanted(projection));
      const auto camera = RelevoMakeWarpCamera(Width, Height, projection, isParallel, 0.0, 0.0);
      warper->SetCamera(camera);
      const double* focal = camera->GetFocalPoint();
      const double x = focal[0];
      const double y = focal[1];
      int expected = 0;
      for (double z : { -60.0, 0.0, 5.0, -30.0, 60.0, -1000.0 })
      {
        camera->SetFocalPoint(x + 5.0, y, z < 0.0 ? plane : plane + z);
        camera->SetPosition(x, y, plane + z);
        if (z > 0.0)
        {
          camera->SetFocalPoint(x, y, plane);
        }
        warper->Update();
        CHECK_EQUAL(warper->CanWarp(), (z < 0.0));
        CHECK_EQUAL((CountSeen(warper->GetOutput()) > 0), (z < 0.0));
        CHECK_EQUAL(warper->GetOutput()->GetNumberOfPoints(), Width * Height);
        expected += z == 0.0 || z == 60.0; // one warning for consecutive positions
        CHECK_EQUAL(warnings.Number, expected);
      }
    }
  }
}

// Parts of the surface lie behind the eye, and depths on both sides of the plane.
void TestBehindEye(RelevoCheck& check)
{
  const auto image = RelevoMakeRelief(Width, Height, ReliefProjection::Parallel, relevo::dmat4(1.0),
    [](int column, int) { return column < Width / 2 ? -50.0 : 3.0; });
  vtkNew<vtkReliefWarper> warper;
  warper->SetInputData(image);
  vtkNew<vtkCamera> camera;
  camera->SetPosition(Width / 2, Height / 2, -20.0);
  camera->SetFocalPoint(Width / 2, Height / 2, 0.0);
  warper->SetCamera(camera);
  warper->Update();
  const double* range = warper->GetOutput()->GetPointData()->GetArray("Depth")->GetFiniteRange();
  CHECK(CountSeen(warper->GetOutput()) > 20 && range[0] == 3.0 && range[1] == 3.0);
}

// The picture does not depend on the unit of length.
void TestUnits(RelevoCheck& check)
{
  const auto image = MakeSlanted(ReliefProjection::Perspective);
  for (double scale : { 1.0, 1e7, 1e-7 })
  {
    CHECK_CASE(scale);
    const auto scaled = RelevoMakeRelief(Width, Height, ReliefProjection::Perspective,
      RelevoPinhole(Width, Height, 1.0 / 60.0),
      [&](int column, int row) { return scale * (60.0 + 0.3 * column + 0.1 * row); });
    vtkNew<vtkReliefWarper> warper;
    warper->SetInputData(scaled);
    vtkNew<vtkCamera> camera;
    camera->SetPosition(9.0 * scale, 0.0, 0.0);
    camera->SetFocalPoint(0.0, 0.0, 60.0 * scale);
    warper->SetCamera(camera);
    warper->Update();
    CHECK_GREATER(CountSeen(warper->GetOutput()), 120);
  }
}

// Random numbers cause no crash and no value that the source does not contain.
void TestAnyNumbers(RelevoCheck& check)
{
  RelevoDice dice(7);
  const double numbers[] = { 0.0, 1.0, -1.0, 1e7, -1e7, 1e30, -1e30, 3e38, 1e-30, NaN, Infinity,
    -Infinity };
  const auto pick = [&] { return numbers[dice.Throw(12)]; };
  int warped = 0;
  for (int i = 0; i < 400; ++i)
  {
    const auto projection =
      dice.Once(2) ? ReliefProjection::Parallel : ReliefProjection::Perspective;
    const auto image = MakeSlanted(projection);
    for (int k = dice.Throw(40); k > 0; --k)
    {
      const double number = projection == ReliefProjection::Perspective ? std::abs(pick()) : pick();
      image->GetPointData()->GetArray("Depth")->SetComponent(
        dice.Throw(Width * Height), 0, number == 0.0 ? 0.5 : number);
    }
    if (dice.Once(3))
    {
      image->GetFieldData()->GetArray("ReliefMatrix")->SetComponent(dice.Throw(16), 0, pick());
    }
    vtkNew<vtkReliefWarper> warper;
    RelevoErrors errors(warper);
    RelevoErrors ofExecutive(warper->GetExecutive());
    warper->SetInputData(image);
    vtkNew<vtkCamera> camera;
    camera->SetFocalPoint(dice.Signed(), dice.Signed(), 10.0);
    camera->SetPosition(dice.Once(4) ? pick() : 3.0, dice.Signed(), dice.Once(4) ? pick() : -9.0);
    camera->SetParallelProjection(dice.Once(2));
    warper->SetCamera(camera);
    warper->SetPolicy(dice.Throw(4));
    warper->SetMaximumStretch(dice.Once(2) ? 8.0 : 1e300);
    warper->Update();
    if (vtkDataArray* depths = warper->GetOutput()->GetPointData()->GetArray("Depth"))
    {
      const double* source = image->GetPointData()->GetArray("Depth")->GetFiniteRange();
      const double* range = depths->GetFiniteRange();
      const double slack = 1e-6 * (std::abs(source[0]) + std::abs(source[1]));
      CHECK(CountSeen(warper->GetOutput()) == 0 ||
        (range[0] >= source[0] - slack && range[1] <= source[1] + slack));
      ++warped;
    }
  }
  CHECK_GREATER(warped, 200);
}
}

int TestReliefWarperErrors(int, char*[])
{
  RelevoCheck check;
  TestErrors(check);
  TestEyes(check);
  TestBehindEye(check);
  TestUnits(check);
  TestAnyNumbers(check);
  return check.GetResult();
}
