// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves limits.md: line integral convolution accepts images of up to 2^22 points along each side,
// which float coordinates can still address.
#include "RelevoCheck.h"
#include "RelevoFlowImages.h"

#include "vtkExecutive.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"

namespace
{
constexpr int LargestSide = 1 << 22;

bool Runs(RelevoCheck& check, int columns, int rows, RelevoErrors& errors,
  vtkLineIntegralConvolution* filter)
{
  vtkNew<vtkFloatArray> vectors;
  vectors->SetName("Flow");
  vectors->SetNumberOfComponents(2);
  vectors->SetNumberOfTuples(static_cast<vtkIdType>(columns) * rows);
  vectors->Fill(1.0);
  vtkNew<vtkImageData> image;
  image->SetDimensions(columns, rows, 1);
  image->GetPointData()->AddArray(vectors);
  filter->SetInputData(image);
  const bool runs = filter->GetExecutive()->Update() == 1;
  CHECK_EQUAL(runs, errors.None());
  return runs;
}
}

int TestLineIntegralConvolutionSize(int, char*[])
{
  RelevoCheck check;
  vtkNew<vtkLineIntegralConvolution> filter;
  RelevoErrors errors(filter);
  RelevoErrors executive(filter->GetExecutive());
  filter->SetNumberOfSteps(1);
  filter->EnhancedLICOff();
  for (const bool isTall : { false, true })
  {
    CHECK_CASE(isTall);
    const int columns = isTall ? 1 : LargestSide;
    const int rows = isTall ? LargestSide : 1;
    CHECK(Runs(check, columns, rows, errors, filter));
    CHECK_EQUAL(filter->GetOutput()->GetNumberOfPoints(), LargestSide);
    CHECK(!Runs(check, columns + !isTall, rows + isTall, errors, filter));
    CHECK(errors.Said("The input has more than 4194304 points per side."));
    CHECK_EQUAL(filter->GetOutput()->GetNumberOfPoints(), 0);
  }
  return check.GetResult();
}
