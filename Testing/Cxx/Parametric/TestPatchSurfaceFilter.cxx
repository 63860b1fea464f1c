// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkPatchSurfaceFilter promises patches that equal VTK's interpolation, for cells of all kinds and
// degrees.
#include "RelevoCheck.h"
#include "RelevoPatches.h"
#include "RelevoSanitizer.h"

#include "vtkCell.h"
#include "vtkCellType.h"
#include "vtkMath.h"

#include <algorithm>
#include <iostream>

namespace
{
double GetDeterminant(const RelevoPosition& a, const RelevoPosition& b, const RelevoPosition& c)
{
  return vtkMath::Determinant3x3(a.data(), b.data(), c.data());
}

// Sum of the integrals of (x . n) dA / 3 over the patches. It is positive if they face outwards.
double GetVolume(vtkPolyData* mesh)
{
  constexpr int steps = 12;
  double sum = 0.0;
  for (int patch = 0; patch < RelevoGetNumberOfPatches(mesh); ++patch)
  {
    const bool isTriangle = RelevoIsTriangle(mesh, patch);
    const auto at = [&](int i, int j)
    {
      const std::vector<double> x = RelevoEvaluatePatch(
        mesh, patch, i / static_cast<double>(steps), j / static_cast<double>(steps));
      return RelevoPosition{ x[0], x[1], x[2] };
    };
    for (int j = 0; j < steps; ++j)
    {
      for (int i = 0; i < (isTriangle ? steps - j : steps); ++i)
      {
        const RelevoPosition b = at(i + 1, j);
        const RelevoPosition d = at(i, j + 1);
        sum += GetDeterminant(at(i, j), b, d) / 6.0;
        if (!isTriangle || i + j + 1 < steps)
        {
          sum += GetDeterminant(b, at(i + 1, j + 1), d) / 6.0;
        }
      }
    }
  }
  return sum;
}

void TestCell(RelevoCheck& check, vtkUnstructuredGrid* grid, int patches)
{
  auto mesh = RelevoMakePatches(grid);
  const bool isSolid = grid->GetCell(0)->GetCellDimension() == 3;
  const double placeError = RelevoGetCellError(grid, mesh);
  const double valueError = RelevoGetCellError(grid, mesh, "Values");
  const bool isRight = RelevoGetNumberOfPatches(mesh) == patches && placeError < 1e-12 &&
    valueError < 1e-12 && (!isSolid || GetVolume(mesh) > 0.0);
  if (!isRight)
  {
    std::cerr << grid->GetCell(0)->GetClassName() << ", " << grid->GetCell(0)->GetNumberOfPoints()
              << " nodes: " << RelevoGetNumberOfPatches(mesh) << " patches of " << patches
              << ", errors " << placeError << " and " << valueError << ", volume "
              << GetVolume(mesh) << "\n";
  }
  CHECK(isRight);
}

struct Kind
{
  int Type;
  int Patches;
  vtkIdType Nodes;
};

void TestFixedDegrees(RelevoCheck& check)
{
  for (const Kind& kind : std::initializer_list<Kind>{ { VTK_TRIANGLE, 1, 0 }, { VTK_QUAD, 1, 0 },
         { VTK_TETRA, 4, 0 }, { VTK_HEXAHEDRON, 6, 0 }, { VTK_WEDGE, 5, 0 }, { VTK_PYRAMID, 5, 0 },
         { VTK_PENTAGONAL_PRISM, 11, 0 }, { VTK_HEXAGONAL_PRISM, 14, 0 },
         { VTK_QUADRATIC_TRIANGLE, 1, 0 }, { VTK_BIQUADRATIC_TRIANGLE, 1, 0 },
         { VTK_QUADRATIC_LINEAR_QUAD, 1, 0 }, { VTK_QUADRATIC_QUAD, 1, 0 },
         { VTK_BIQUADRATIC_QUAD, 1, 0 }, { VTK_QUADRATIC_TETRA, 4, 0 },
         { VTK_QUADRATIC_HEXAHEDRON, 6, 0 }, { VTK_BIQUADRATIC_QUADRATIC_HEXAHEDRON, 6, 0 },
         { VTK_TRIQUADRATIC_HEXAHEDRON, 6, 0 }, { VTK_QUADRATIC_LINEAR_WEDGE, 5, 0 },
         { VTK_QUADRATIC_WEDGE, 5, 0 }, { VTK_BIQUADRATIC_QUADRATIC_WEDGE, 5, 0 },
         { VTK_QUADRATIC_PYRAMID, 5, 0 }, { VTK_TRIQUADRATIC_PYRAMID, 5, 0 },
         { VTK_LAGRANGE_TRIANGLE, 1, 7 }, { VTK_LAGRANGE_TETRAHEDRON, 4, 15 },
         { VTK_LAGRANGE_WEDGE, 5, 21 } })
  {
    TestCell(check, RelevoNewCell(kind.Type, { 2, 2, 2 }, 0.1, false, kind.Nodes), kind.Patches);
  }
  // VTK treats these cells as parallel to the axes.
  TestCell(check, RelevoNewCell(VTK_PIXEL, { 1, 1, 1 }, 0.0), 1);
  TestCell(check, RelevoNewCell(VTK_VOXEL, { 1, 1, 1 }, 0.0), 6);
}

void TestAnyDegrees(RelevoCheck& check)
{
  for (int p = 1; p <= 8; ++p)
  {
    if (RelevoHasAddressSanitizer && p > 3 && p < 8)
    {
      continue; // the same code takes long
    }
    for (bool isBezier : { false, true })
    {
      CHECK_CASE(isBezier);
      const int first = isBezier ? VTK_BEZIER_CURVE : VTK_LAGRANGE_CURVE;
      const int q = (3 * p) % 8 + 1;
      const int r = (5 * p + 2) % 8 + 1;
      for (bool isRational : { false, true })
      {
        CHECK_CASE(isRational);
        if (isBezier || !isRational)
        {
          const double share = 0.2 / p;
          TestCell(check, RelevoNewCell(first + 1, { p, p, p }, share, isRational), 1);
          TestCell(check, RelevoNewCell(first + 2, { p, q, 0 }, share, isRational), 1);
          TestCell(check, RelevoNewCell(first + 3, { p, p, p }, share, isRational), 4);
          TestCell(check, RelevoNewCell(first + 4, { p, q, r }, share, isRational), 6);
          TestCell(check, RelevoNewCell(first + 5, { p, p, q }, share, isRational), 5);
        }
      }
    }
  }
}
}

int TestPatchSurfaceFilter(int, char*[])
{
  RelevoCheck check;
  TestFixedDegrees(check);
  TestAnyDegrees(check);
  return check.GetResult();
}
