// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves that gradients at points are exact for a linear field in cells of every kind,
// volume-weighted means where cells differ, and the same for a mesh in blocks.
#include "Cells/PointGradients.h"
#include "Cells/VolumeCells.h"
#include "RelevoCheck.h"
#include "RelevoVolumes.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkCellTypeSource.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <cmath>

namespace
{
using relevo::dvec3;
using relevo::VolumeCells;

void SetField(vtkDataSet* mesh, const RelevoField& field)
{
  vtkNew<vtkDoubleArray> scalars;
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    RelevoPoint point;
    mesh->GetPoint(i, point.data());
    scalars->InsertNextValue(field(point));
  }
  mesh->GetPointData()->SetScalars(scalars);
}

void Add(VolumeCells& cells, vtkDataSet* mesh)
{
  cells.Add(mesh, mesh->GetPointData()->GetScalars(), false, {});
  cells.ConvertCurved();
}

std::vector<relevo::Gradients> Compute(vtkDataSet* mesh)
{
  VolumeCells cells;
  Add(cells, mesh);
  cells.MoveToOrigin();
  return ComputePointGradients(cells);
}

bool IsNear(const dvec3& a, const dvec3& b, double tolerance)
{
  return distance(a, b) <= tolerance;
}

void TestLinear(RelevoCheck& check)
{
  for (const int type : { VTK_TETRA, VTK_HEXAHEDRON, VTK_WEDGE, VTK_PYRAMID, VTK_QUADRATIC_TETRA })
  {
    vtkNew<vtkCellTypeSource> source;
    source->SetCellType(type);
    source->SetBlocksDimensions(3, 2, 2);
    source->Update();
    vtkDataSet* mesh = source->GetOutput();
    SetField(mesh, [](const RelevoPoint& p) { return 2.0 * p[0] - p[1] + 0.5 * p[2] + 7.0; });
    for (const relevo::Gradients& gradient : Compute(mesh))
    {
      CHECK(IsNear(gradient[0], dvec3(2.0, -1.0, 0.5), 1e-12));
      CHECK_EQUAL(gradient[1], dvec3(0.0));
    }
    SetField(mesh, [](const RelevoPoint&) { return 0.1; });
    for (const relevo::Gradients& gradient : Compute(mesh))
    {
      CHECK_EQUAL(gradient[0], dvec3(0.0)); // exactly
    }
  }
}

// In a regular grid, the mean is exact even for a quadratic field.
void TestQuadratic(RelevoCheck& check)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(5, 5, 5);
  image->SetSpacing(0.5, 1.0, 2.0);
  SetField(
    image, [](const RelevoPoint& p) { return p[0] * p[0] + 2.0 * p[1] * p[1] - p[0] * p[2]; });
  const auto gradients = Compute(image);
  for (int i = 0; i < 27; ++i)
  {
    const vtkIdType point = (1 + i % 3) + 5 * (1 + i / 3 % 3) + 25 * (1 + i / 9);
    RelevoPoint p;
    image->GetPoint(point, p.data());
    CHECK(IsNear(gradients[point][0], dvec3(2.0 * p[0] - p[2], 4.0 * p[1], -p[0]), 1e-12));
  }
}

// Two tetrahedra share a face. One is three times as high as the other, and their gradients across
// it are 1 and 2. A hexahedron and a pyramid have other volumes.
void TestVolumes(RelevoCheck& check)
{
  vtkNew<vtkUnstructuredGrid> mesh;
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0.0, 0.0, 0.0);
  points->InsertNextPoint(1.0, 0.0, 0.0);
  points->InsertNextPoint(0.0, 1.0, 0.0);
  points->InsertNextPoint(0.0, 0.0, 1.0);
  points->InsertNextPoint(0.0, 0.0, -3.0);
  mesh->SetPoints(points);
  const vtkIdType above[4] = { 0, 1, 2, 3 };
  const vtkIdType below[4] = { 4, 2, 1, 0 };
  mesh->InsertNextCell(VTK_TETRA, 4, above);
  mesh->InsertNextCell(VTK_TETRA, 4, below);
  SetField(mesh, [](const RelevoPoint& p) { return p[2] > 0.0 ? p[2] : 2.0 * p[2]; });
  const auto gradients = Compute(mesh);
  CHECK(IsNear(gradients[0][0], dvec3(0.0, 0.0, 1.75), 1e-12));
  CHECK(IsNear(gradients[3][0], dvec3(0.0, 0.0, 1.0), 1e-12));
  CHECK(IsNear(gradients[4][0], dvec3(0.0, 0.0, 2.0), 1e-12));

  // A cube has a pyramid of height 1 on top. The volumes are 1 and 1/3.
  vtkNew<vtkUnstructuredGrid> house;
  vtkNew<vtkPoints> corners;
  for (int i = 0; i < 8; ++i)
  {
    const int turn = i % 4;
    corners->InsertNextPoint(turn == 1 || turn == 2 ? 1.0 : 0.0, turn / 2, i / 4 - 1.0);
  }
  corners->InsertNextPoint(0.5, 0.5, 1.0);
  house->SetPoints(corners);
  const vtkIdType cube[8] = { 0, 1, 2, 3, 4, 5, 6, 7 };
  const vtkIdType roof[5] = { 4, 5, 6, 7, 8 };
  house->InsertNextCell(VTK_HEXAHEDRON, 8, cube);
  house->InsertNextCell(VTK_PYRAMID, 5, roof);
  SetField(house, [](const RelevoPoint& p) { return p[2] > 0.0 ? 5.0 * p[2] : p[2]; });
  CHECK(IsNear(Compute(house)[4][0], dvec3(0.0, 0.0, 2.0), 1e-12));

  // Cells without point scalars contribute nothing.
  vtkNew<vtkDoubleArray> ids;
  ids->InsertNextValue(1.0);
  ids->InsertNextValue(2.0);
  mesh->GetCellData()->SetScalars(ids);
  VolumeCells cells;
  cells.Add(mesh, ids, true, {});
  cells.MoveToOrigin();
  for (const relevo::Gradients& gradient : ComputePointGradients(cells))
  {
    CHECK_EQUAL(gradient[0], dvec3(0.0));
  }
}

// Coincident points of blocks are merged if they have the same scalars.
void TestBlocks(RelevoCheck& check)
{
  const auto getBent = [](const RelevoPoint& p) { return std::abs(p[0] - 1.0) + p[1] * p[1]; };
  vtkNew<vtkImageData> whole;
  whole->SetDimensions(5, 3, 3);
  whole->SetSpacing(0.5, 0.5, 0.5);
  SetField(whole, getBent);
  const auto expected = Compute(whole);
  vtkNew<vtkImageData> first;
  first->SetDimensions(3, 3, 3);
  first->SetSpacing(0.5, 0.5, 0.5);
  vtkNew<vtkImageData> second;
  second->DeepCopy(first);
  second->SetOrigin(1.0, 0.0, 0.0);
  const auto compute = [&](double jump)
  {
    SetField(first, getBent);
    SetField(second, [&](const RelevoPoint& p) { return getBent(p) + jump; });
    VolumeCells cells;
    Add(cells, first);
    Add(cells, second);
    cells.MoveToOrigin();
    return ComputePointGradients(cells);
  };
  const auto joined = compute(0.0);
  const auto apart = compute(1.0);
  for (vtkIdType i = 0; i < 27; ++i)
  {
    const vtkIdType row = 5 * (i / 3);
    CHECK(IsNear(joined[i][0], expected[row + i % 3][0], 1e-12));
    CHECK(IsNear(joined[27 + i][0], expected[row + 2 + i % 3][0], 1e-12));
  }
  CHECK_LESS(std::abs(joined[2][0].x), 1e-12);
  CHECK_NEAR(apart[2][0].x, -1.0, 1e-12);
  CHECK_NEAR(apart[27][0].x, 1.0, 1e-12);
}
}

int TestPointGradients(int, char*[])
{
  RelevoCheck check;
  TestLinear(check);
  TestQuadratic(check);
  TestVolumes(check);
  TestBlocks(check);
  return check.GetResult();
}
