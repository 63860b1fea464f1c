// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkDepthImageToRelief promises one ErrorEvent and an empty output for depth images that it cannot
// use.
#include "RelevoBlocks.h"
#include "RelevoCheck.h"
#include "RelevoReliefs.h"

#include "vtkCamera.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDepthImageToRelief.h"
#include "vtkExecutive.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

namespace
{
vtkSmartPointer<vtkImageData> MakeDepths(double depth = 2.0)
{
  return RelevoMakeImage(4, 3, VTK_FLOAT, [=](int, int) { return depth; });
}

vtkSmartPointer<vtkDepthImageToRelief> MakeFilter()
{
  auto filter = vtkSmartPointer<vtkDepthImageToRelief>::New();
  filter->SetInputData(MakeDepths());
  filter->SetIntrinsics(4.0, 4.0, 1.5, 1.0);
  return filter;
}

void ExpectError(RelevoCheck& check, vtkDepthImageToRelief* filter, const char* words)
{
  RelevoErrors errors(filter);
  RelevoErrors executive(filter->GetExecutive());
  CHECK_EQUAL(filter->GetExecutive()->Update(), 0);
  CHECK(errors.Said(words));
  CHECK_EQUAL(filter->GetOutput()->GetNumberOfPoints(), 0);
  // The filter works again after the input is corrected.
  filter->SetInputData(MakeDepths());
  filter->SetInputConnection(1, nullptr);
  filter->SetPose(nullptr);
  filter->SetCamera(nullptr);
  filter->SetIntrinsics(4.0, 4.0, 1.5, 1.0);
  CHECK_EQUAL(filter->GetExecutive()->Update(), 1);
  CHECK(errors.None() && filter->GetOutput()->GetNumberOfPoints() == 12);
}

// The named array is a cell array.
void TestCellArray(RelevoCheck& check)
{
  vtkNew<vtkFloatArray> ofCells;
  ofCells->SetName("Range");
  const auto image = MakeDepths();
  ofCells->SetNumberOfTuples(image->GetNumberOfCells());
  ofCells->Fill(1.0);
  image->GetCellData()->AddArray(ofCells);
  auto filter = MakeFilter();
  filter->SetInputData(image);
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Range");
  RelevoErrors errors(filter);
  RelevoErrors executive(filter->GetExecutive());
  filter->Update();
  CHECK(errors.Said("The depth image has no point array \"Range\", but a cell array of that name. "
                    "Convert it with vtkCellDataToPointData."));
}

void TestImages(RelevoCheck& check)
{
  auto filter = MakeFilter();
  vtkNew<vtkImageData> image;
  image->SetDimensions(4, 3, 2);
  image->AllocateScalars(VTK_FLOAT, 1);
  filter->SetInputData(image);
  ExpectError(check, filter, "The depth image has 4 x 3 x 2 points, but n x m x 1 are needed.");

  vtkNew<vtkImageData> bare;
  bare->SetDimensions(4, 3, 1);
  filter->SetInputData(bare);
  ExpectError(check, filter, "The depth image has no point scalars.");

  filter->SetInputData(RelevoMakeImage(
    4, 3, VTK_FLOAT, [](int, int) { return 2.0; }, 3));
  ExpectError(check, filter, "12 tuples of 3 components, but one number for each of 12 points");

  const auto few = MakeDepths();
  few->GetPointData()->GetScalars()->SetNumberOfTuples(7);
  filter->SetInputData(few);
  ExpectError(check, filter, "7 tuples of 1 components, but one number for each of 12 points");

  filter->SetInputData(MakeDepths(-1.0));
  ExpectError(check, filter, "No value of the point array 'Depth' is finite.");

  filter = MakeFilter();
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Range");
  RelevoErrors errors(filter);
  RelevoErrors executive(filter->GetExecutive());
  CHECK_EQUAL(filter->GetExecutive()->Update(), 0);
  CHECK(errors.Said("The depth image has no point array \"Range\"."));
}

void TestColors(RelevoCheck& check)
{
  const auto filter = MakeFilter();
  const auto zero = [](int, int) { return 0.0; };
  filter->SetInputData(1, RelevoMakeImage(3, 4, VTK_UNSIGNED_CHAR, zero, 3));
  ExpectError(check, filter,
    "The colour image has 3 x 4 x 1 points and 12 colours, but the depth image has 4 x 3 x 1");
  filter->SetInputData(1, RelevoMakeImage(4, 3, VTK_INT, zero, 3));
  ExpectError(check, filter, "not 3 of type int");
  filter->SetInputData(1, RelevoMakeImage(4, 3, VTK_UNSIGNED_CHAR, zero, 5));
  ExpectError(check, filter, "Colours must have 1 to 4 components");
  vtkNew<vtkImageData> bare;
  bare->SetDimensions(4, 3, 1);
  filter->SetInputData(1, bare);
  ExpectError(check, filter, "The colour image has no point scalars.");
}

void TestCameras(RelevoCheck& check)
{
  vtkNew<vtkDepthImageToRelief> fresh;
  fresh->SetInputData(MakeDepths());
  ExpectError(check, fresh, "There are neither intrinsics nor a camera");

  const auto filter = MakeFilter();
  vtkNew<vtkMatrix4x4> flat;
  flat->SetElement(1, 1, 0.0);
  filter->SetPose(flat);
  ExpectError(check, filter, "'ReliefMatrix' is a singular matrix");

  vtkNew<vtkCamera> camera;
  camera->SetUseExplicitProjectionTransformMatrix(true);
  camera->SetExplicitProjectionTransformMatrix(flat);
  filter->SetInputData(MakeDepths(0.5));
  filter->SetCamera(camera);
  ExpectError(check, filter, "The camera's matrices are singular");
}

void TestBlocks(RelevoCheck& check)
{
  const auto filter = MakeFilter();
  CHECK(RelevoRefusesBlock(
    filter, 0, vtkNew<vtkPolyData>(), "The input is a vtkPolyData; a vtkImageData is needed."));
  filter->SetInputData(MakeDepths());
  CHECK(RelevoRefusesBlock(
    filter, 1, vtkNew<vtkTable>(), "The input of port 1 is a vtkTable; a vtkImageData is needed."));
}

void TestSettings(RelevoCheck& check)
{
  const auto filter = MakeFilter();
  RelevoErrors errors(filter);
  filter->SetDepthScale(0.0);
  CHECK(errors.Said("DepthScale must be more than 0 and finite, got 0."));
  CHECK_EQUAL(filter->GetDepthScale(), 1.0);
  filter->SetIntrinsics(1.0, -1.0, 0.0, 0.0);
  CHECK(
    errors.Said("Intrinsics must be finite, with fx and fy of more than 0, got (1, -1, 0, 0)."));
  CHECK_EQUAL(filter->GetIntrinsics()[1], 4.0);
}
}

int TestDepthImageToReliefErrors(int, char*[])
{
  RelevoCheck check;
  TestImages(check);
  TestCellArray(check);
  TestColors(check);
  TestCameras(check);
  TestBlocks(check);
  TestSettings(check);
  return check.GetResult();
}
