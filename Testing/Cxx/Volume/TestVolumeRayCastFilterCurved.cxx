// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkVolumeRayCastFilter draws curved cells by their own basis: shape and field are compared with
// closed forms, which each basis reproduces.
#include "RelevoCheck.h"
#include "RelevoCurvedCells.h"

#include "vtkCellType.h"

#include <vector>

namespace
{
constexpr int Width = 16;
constexpr int Height = 12;

void Check(RelevoCheck& check, int type, int degree)
{
  CHECK_CASE(100 * type + degree);
  const RelevoCurvedCells cells(degree);
  const auto camera = MakeCamera({ { 2.1, 1.6, 1.9 } }, { { 0.5, 0.5, 0.5 } }, 32.0);
  const auto picture =
    Cast(cells.Make(type, 1), MakeVolumeProperty(0.2, 1.0, 0.3), camera, Width, Height);
  const auto expected = cells.MakePicture(camera, Width, Height, 0.2, 1.0, 0.3);
  CHECK_NEAR(CompareInside(picture, expected, Width), 0.0, 0.3); // steps of the samples
}
}

int TestVolumeRayCastFilterCurved(int, char*[])
{
  RelevoCheck check;
  for (int type : { VTK_QUADRATIC_HEXAHEDRON, VTK_TRIQUADRATIC_HEXAHEDRON,
         VTK_BIQUADRATIC_QUADRATIC_HEXAHEDRON, VTK_QUADRATIC_WEDGE, VTK_BIQUADRATIC_QUADRATIC_WEDGE,
         VTK_QUADRATIC_LINEAR_WEDGE, VTK_QUADRATIC_TETRA })
  {
    Check(check, type, 2);
  }
  for (int degree : { 3, 4, 8 })
  {
    Check(check, VTK_LAGRANGE_HEXAHEDRON, degree);
    Check(check, VTK_LAGRANGE_WEDGE, degree);
    Check(check, VTK_LAGRANGE_TETRAHEDRON, degree);
  }
  for (int type : { VTK_BEZIER_HEXAHEDRON, VTK_BEZIER_WEDGE, VTK_BEZIER_TETRAHEDRON })
  {
    Check(check, type, 3);
  }
  return check.GetResult();
}
