// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves which points a ghost array hides and which arrays are ignored. The arrays end at the end
// of a memory page, so that reading further crashes.
#include "Mesh/PointBlanking.h"
#include "RelevoCheck.h"
#include "RelevoFuzz.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"

namespace
{
// The third point of each row is hidden.
vtkSmartPointer<vtkUnsignedCharArray> MakeGhosts(vtkIdType tuples, int components)
{
  auto ghosts = vtkSmartPointer<vtkUnsignedCharArray>::New();
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  ghosts->SetNumberOfComponents(components);
  ghosts->SetNumberOfTuples(tuples);
  for (vtkIdType i = 0; i < ghosts->GetNumberOfValues(); ++i)
  {
    ghosts->SetValue(i,
      i % 4 == 2 ? vtkDataSetAttributes::HIDDENPOINT | vtkDataSetAttributes::DUPLICATEPOINT
                 : vtkDataSetAttributes::DUPLICATEPOINT);
  }
  RelevoFuzz::Fence(ghosts);
  return ghosts;
}
}

int TestPointBlanking(int, char*[])
{
  RelevoCheck check;
  constexpr vtkIdType points = 12;
  const auto test = [&check](vtkIdType tuples, int components, bool isUsed)
  {
    vtkNew<vtkImageData> image;
    image->SetDimensions(4, 3, 1);
    image->GetPointData()->AddArray(MakeGhosts(tuples, components));
    const relevo::PointBlanking blanking(image);
    CHECK_EQUAL(blanking.HidesAny(), isUsed);
    for (vtkIdType point = 0; point < points; ++point)
    {
      CHECK_EQUAL(blanking.IsHidden(point), (isUsed && point % 4 == 2));
    }
  };
  test(points, 1, true);
  test(points + 5, 1, true);
  test(points - 1, 1, false);
  test(1, 1, false);
  test(0, 1, false);
  test(points, 2, false);
  test(points / 2, 2, false); // as many values as points

  vtkNew<vtkImageData> image;
  image->SetDimensions(4, 3, 1);
  const relevo::PointBlanking none(image);
  CHECK(!none.HidesAny() && !none.IsHidden(2));
  return check.GetResult();
}
