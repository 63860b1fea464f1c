// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RelevoPatchMeshes.h"

#include "RelevoPatches.h"

#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkNURBSSource.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

#include <array>
#include <cmath>
#include <vector>

namespace
{
using Profile = std::vector<std::array<double, 2>>; // distance from the axis, height

// Rotates a profile of quarter circles about the z axis.
vtkSmartPointer<vtkPolyData> Turn(const Profile& profile)
{
  const Profile circle = { { { 1, 0 } }, { { 1, 1 } }, { { 0, 1 } }, { { -1, 1 } }, { { -1, 0 } },
    { { -1, -1 } }, { { 0, -1 } }, { { 1, -1 } }, { { 1, 0 } } };
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> weights;
  const auto weight = [](size_t i) { return i % 2 == 0 ? 1.0 : std::sqrt(0.5); };
  for (size_t j = 0; j < profile.size(); ++j)
  {
    for (size_t i = 0; i < circle.size(); ++i)
    {
      const double radius = profile[j][0];
      points->InsertNextPoint(radius * circle[i][0], radius * circle[i][1], profile[j][1]);
      weights->InsertNextValue(weight(i) * weight(j));
    }
  }
  vtkNew<vtkNURBSSource> source;
  const size_t sizes[2] = { circle.size(), profile.size() };
  for (int direction = 0; direction < 2; ++direction)
  {
    vtkNew<vtkDoubleArray> knots;
    const int spans = static_cast<int>(sizes[direction] / 2);
    for (int k = 0; k <= spans; ++k)
    {
      const int times = k == 0 || k == spans ? 3 : 2;
      for (int i = 0; i < times; ++i)
      {
        knots->InsertNextValue(k);
      }
    }
    source->SetDegree(direction, 2);
    source->SetKnots(direction, knots);
  }
  source->SetDimensions(static_cast<int>(sizes[0]), static_cast<int>(sizes[1]));
  source->SetControlPoints(points);
  source->SetWeights(weights);
  source->Update();
  return RelevoMakePatches(source->GetOutput());
}
}

vtkSmartPointer<vtkPolyData> RelevoNewPatchTorus()
{
  return Turn({ { { 2.5, 0 } }, { { 2.5, 0.5 } }, { { 2, 0.5 } }, { { 1.5, 0.5 } }, { { 1.5, 0 } },
    { { 1.5, -0.5 } }, { { 2, -0.5 } }, { { 2.5, -0.5 } }, { { 2.5, 0 } } });
}

vtkSmartPointer<vtkPolyData> RelevoNewPatchSphere()
{
  return Turn({ { { 0, -1 } }, { { 1, -1 } }, { { 1, 0 } }, { { 1, 1 } }, { { 0, 1 } } });
}

vtkSmartPointer<vtkPolyData> RelevoNewPatchCube()
{
  return RelevoMakePatches(RelevoNewCell(VTK_LAGRANGE_HEXAHEDRON, { { 3, 3, 3 } }, 0.05));
}
