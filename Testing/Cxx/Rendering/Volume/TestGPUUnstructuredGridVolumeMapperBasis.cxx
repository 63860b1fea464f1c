// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// The default tolerances of curved cells keep the accuracy of volumes.md: 3/255 at most, and 1/255
// at 99.5 % of the pixels, off outlines, compared with closed forms of shape and field.
#include "RelevoCheck.h"
#include "RelevoCurvedCells.h"
#include "RelevoVolumeScene.h"

#include "vtkCellType.h"

namespace
{
constexpr int Width = 60;
constexpr int Height = 45;

void Check(RelevoCheck& check, int type, int degree)
{
  CHECK_CASE(100 * type + degree);
  const RelevoCurvedCells cells(degree);
  const auto mesh = cells.Make(type, degree < 4 ? 2 : 1);
  RelevoVolumeScene scene(mesh, MakeVolumeProperty(0.2, 1.0, 0.3), Width, Height);
  const auto picture = scene.Draw();
  const auto expected = cells.MakePicture(scene.GetCamera(), Width, Height, 0.2, 1.0, 0.3);
  CHECK_LESS(CompareInside(picture, expected, Width), 3.0);
  CHECK_LESS(CompareInside(picture, expected, Width, 0.005), 1.0);
  if (degree == 2) // other shapes are entered twice
  {
    CHECK_EQUAL(scene.GetMapper()->GetNumberOfLayers(), 1);
  }
  CHECK_EQUAL(scene.GetMapper()->GetNumberOfDrawnCells(), mesh->GetNumberOfCells());
}
}

int TestGPUUnstructuredGridVolumeMapperBasis(int, char*[])
{
  RelevoCheck check;
  Check(check, VTK_QUADRATIC_HEXAHEDRON, 2);
  Check(check, VTK_TRIQUADRATIC_HEXAHEDRON, 2);
  Check(check, VTK_QUADRATIC_WEDGE, 2);
  for (int degree : { 3, 4, 8 })
  {
    Check(check, VTK_LAGRANGE_HEXAHEDRON, degree);
    Check(check, VTK_LAGRANGE_TETRAHEDRON, degree);
  }
  Check(check, VTK_LAGRANGE_WEDGE, 3);
  Check(check, VTK_BEZIER_HEXAHEDRON, 3);
  return check.GetResult();
}
