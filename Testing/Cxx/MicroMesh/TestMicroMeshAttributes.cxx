// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkMicroMeshFilter and vtkMicroMeshSurface promise the arrays of the dense mesh on the
// refined mesh, with its detail, and on both sides of a seam.
#include "RelevoCheck.h"
#include "RelevoMicroMeshes.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkMicroMeshFilter.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>

using namespace RelevoMicroMeshes;

namespace
{
constexpr double Tolerance = 0.004;

// Detail that the coarse mesh has not.
double Wave(const double x[3])
{
  return std::sin(9.0 * x[0]) + std::cos(8.0 * x[1]) + x[2];
}
constexpr double Slope = 13.0; // the largest of the wave

void AddArrays(vtkPolyData* mesh)
{
  vtkNew<vtkFloatArray> wave;
  wave->SetName("Wave");
  wave->SetNumberOfComponents(2);
  vtkNew<vtkUnsignedCharArray> grey;
  grey->SetName("Grey");
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName("Ids");
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double x[3];
    mesh->GetPoint(i, x);
    wave->InsertNextTuple2(Wave(x), -x[0]);
    grey->InsertNextValue(static_cast<unsigned char>(120.0 + 30.0 * Wave(x)));
    ids->InsertNextValue(i);
  }
  mesh->GetPointData()->AddArray(wave);
  mesh->GetPointData()->SetScalars(grey);
  mesh->GetPointData()->AddArray(ids);
}

// The largest difference of a component from the function, at all points of a mesh.
template <class Function>
double GetLargest(vtkPolyData* mesh, const char* name, int component, const Function& f)
{
  vtkDataArray* array = mesh->GetPointData()->GetArray(name);
  double largest = 0.0;
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double x[3];
    mesh->GetPoint(i, x);
    largest = std::max(largest, std::abs(array->GetComponent(i, component) - f(x)));
  }
  return largest;
}

void CheckDetail(RelevoCheck& check, const Mesh& dense)
{
  vtkNew<vtkMicroMeshFilter> filter;
  filter->SetInputData(dense);
  filter->SetTolerance(Tolerance);
  filter->Update();
  vtkPolyData* micro = filter->GetOutput();
  CHECK(micro->GetFieldData()->GetArray("MicroMeshPointData:Wave") != nullptr);
  CHECK(micro->GetFieldData()->GetArray("MicroMeshPointData:Ids") == nullptr);
  CHECK(micro->GetFieldData()->GetArray("MicroMeshPointData:Normals") == nullptr);
  const Mesh fine = Decode(micro, 5);
  // The dense mesh interpolates the wave between its points, too.
  CHECK(!fine->GetFieldData()->HasArray("MicroMeshPointData:Wave"));
  CHECK(!fine->GetCellData()->HasArray("MicroMeshFaces"));
  CHECK(!fine->GetPointData()->HasArray("MicroMeshDirections"));
  const double bound = Slope * Tolerance + 0.1;
  CHECK_LESS(GetLargest(fine, "Wave", 0, Wave), bound);
  CHECK_LESS(GetLargest(fine, "Wave", 1, [](const double x[3]) { return -x[0]; }), 2.0 * Tolerance);
  CHECK_LESS(GetLargest(fine, "Grey", 0, [](const double x[3]) { return 120.0 + 30.0 * Wave(x); }),
    30.0 * bound + 1.0);
  filter->AttributesOff();
  filter->Update();
  CHECK(micro->GetFieldData()->GetArray("MicroMeshPointData:Wave") == nullptr);
  CHECK_GREATER(GetLargest(Decode(micro, 5), "Wave", 0, Wave), 4.0 * bound);
}

// The triangles of a mesh whose value is not the side that they are on, away from the border.
int CountWrong(vtkPolyData* mesh)
{
  constexpr double margin = 0.12; // about the edges of the dense mesh
  vtkDataArray* half = mesh->GetCellData()->GetArray("Half");
  int wrong = 0;
  for (vtkIdType t = 0; t < mesh->GetNumberOfCells(); ++t)
  {
    vtkIdType size;
    const vtkIdType* ids;
    mesh->GetCellPoints(t, size, ids);
    double x = 0.0;
    for (int c = 0; c < 3; ++c)
    {
      x += mesh->GetPoint(ids[c])[0] / 3.0;
    }
    wrong += std::abs(x) > margin && half->GetComponent(t, 0) != (x < 0.0 ? -1.0 : 1.0) ? 1 : 0;
  }
  return wrong;
}

// Cell arrays have a value per triangle of the grids.
void CheckCells(RelevoCheck& check, const Mesh& dense)
{
  vtkNew<vtkFloatArray> half;
  half->SetName("Half");
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName("vtkGhostType");
  for (vtkIdType t = 0; t < dense->GetNumberOfCells(); ++t)
  {
    double bounds[6];
    dense->GetCellBounds(t, bounds);
    half->InsertNextValue(bounds[0] + bounds[1] < 0.0 ? -1.0f : 1.0f);
    ghosts->InsertNextValue(0);
  }
  dense->GetCellData()->AddArray(half);
  dense->GetCellData()->AddArray(ghosts);
  vtkNew<vtkMicroMeshFilter> filter;
  filter->SetInputData(dense);
  filter->SetTolerance(Tolerance);
  filter->Update();
  vtkPolyData* micro = filter->GetOutput();
  CHECK(micro->GetFieldData()->GetArray("MicroMeshCellData:Half") != nullptr);
  CHECK(micro->GetFieldData()->GetArray("MicroMeshCellData:vtkGhostType") == nullptr);
  const Mesh fine = Decode(micro, 5);
  CHECK(!fine->GetFieldData()->HasArray("MicroMeshCellData:Half"));
  CHECK_EQUAL(CountWrong(fine), 0);
  // At lower levels, triangles have the value at their centre.
  CHECK_LESS(CountWrong(Decode(micro, 3)), 40);
  filter->AttributesOff();
  filter->Update();
  CHECK(micro->GetFieldData()->GetArray("MicroMeshCellData:Half") == nullptr);
  CHECK_GREATER(CountWrong(Decode(micro, 5)), 1000);
}

// A plate of which each half has separate points. The array is the side of the half.
void CheckSeam(RelevoCheck& check)
{
  const Mesh plate = Plate(24);
  vtkNew<vtkPolyData> halves;
  vtkNew<vtkPoints> points;
  points->DeepCopy(plate->GetPoints());
  vtkNew<vtkFloatArray> side;
  side->SetName("Side");
  const vtkIdType number = plate->GetNumberOfPoints();
  for (vtkIdType i = 0; i < 2 * number; ++i)
  {
    if (i >= number)
    {
      points->InsertNextPoint(plate->GetPoint(i - number));
    }
    side->InsertNextValue(i < number ? -1.0f : 1.0f);
  }
  vtkNew<vtkCellArray> triangles;
  for (vtkIdType t = 0; t < plate->GetNumberOfCells(); ++t)
  {
    vtkIdType size;
    const vtkIdType* ids;
    plate->GetCellPoints(t, size, ids);
    double y = 0.0;
    for (int c = 0; c < 3; ++c)
    {
      y += plate->GetPoint(ids[c])[1] / 3.0;
    }
    const vtkIdType first = y < plate->GetCenter()[1] ? 0 : number;
    const vtkIdType corners[3] = { ids[0] + first, ids[1] + first, ids[2] + first };
    triangles->InsertNextCell(3, corners);
  }
  halves->SetPoints(points);
  halves->SetPolys(triangles);
  halves->GetPointData()->AddArray(side);
  const Mesh fine = Decode(Encode(halves, 0.01), 4);
  vtkDataArray* values = fine->GetPointData()->GetArray("Side");
  int other = 0;
  vtkIdType sides[2] = { 0, 0 };
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    const double value = values->GetComponent(i, 0);
    other += std::abs(value) == 1.0 ? 0 : 1;
    ++sides[value > 0.0 ? 1 : 0];
  }
  CHECK_EQUAL(other, 0);
  CHECK_GREATER(std::min(sides[0], sides[1]), 100);
}
}

int TestMicroMeshAttributes(int, char*[])
{
  RelevoCheck check;
  const Mesh dense = ReliefSphere(64, 40);
  AddArrays(dense);
  CheckDetail(check, dense);
  CheckCells(check, dense);
  CheckSeam(check);
  return check.GetResult();
}
