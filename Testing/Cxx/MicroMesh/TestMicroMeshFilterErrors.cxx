// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkMicroMeshFilter promises one clear error or a warning for bad input and settings, and its
// tolerance for all meshes that it encodes.
#include "RelevoCheck.h"
#include "RelevoMicroMeshes.h"

#include "vtkAppendPolyData.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkMicroMeshFilter.h"
#include "vtkPointData.h"
#include "vtkShortArray.h"

#include <cmath>
#include <limits>
#include <vector>

using namespace RelevoMicroMeshes;

namespace
{
void CheckSettings(RelevoCheck& check)
{
  vtkNew<vtkMicroMeshFilter> filter;
  RelevoErrors errors(filter);
  filter->SetInputData(RelevoMeshes::Sphere(8, 6));
  filter->Update();
  CHECK(errors.Said("Tolerance is not set"));
  CHECK_EQUAL(filter->GetOutput()->GetNumberOfCells(), 0);
  filter->SetTolerance(0.5);
  const double infinity = std::numeric_limits<double>::infinity();
  for (double bad : { 0.0, -1.0, infinity, std::nan("") })
  {
    CHECK_CASE(bad);
    filter->SetTolerance(bad);
    CHECK(errors.Said("Tolerance must be more than 0"));
    CHECK_EQUAL(filter->GetTolerance(), 0.5);
  }
  filter->SetTargetReduction(1.5);
  CHECK(errors.Said("TargetReduction must be in [0, 1]"));
  filter->SetMaximumLevel(8);
  CHECK(errors.Said("MaximumLevel must be in [0, 7]"));
  filter->SetFeatureAngle(-1.0);
  CHECK(errors.Said("FeatureAngle must be in [0, 180]"));
  filter->Update();
  CHECK(errors.None());
  CHECK_GREATER(filter->GetOutput()->GetNumberOfCells(), 3);
}

// Updates with a mesh and returns the number of cells.
vtkIdType Update(vtkMicroMeshFilter* filter, vtkPolyData* mesh)
{
  filter->SetInputData(mesh);
  filter->Update();
  return filter->GetOutput()->GetNumberOfCells();
}

void CheckArrays(RelevoCheck& check)
{
  vtkNew<vtkMicroMeshFilter> filter;
  RelevoErrors errors(filter);
  filter->SetTolerance(0.01);
  const Mesh plate = Plate(6);
  filter->SetMaterialArrayName("Stuff");
  CHECK_EQUAL(Update(filter, plate), 0);
  CHECK(errors.Said("no numeric cell array \"Stuff\""));
  vtkNew<vtkShortArray> tooShort;
  tooShort->SetName("Stuff");
  tooShort->InsertNextValue(1);
  plate->GetCellData()->AddArray(tooShort);
  CHECK_EQUAL(Update(filter, plate), 0);
  CHECK(errors.Said("\"Stuff\" has 1 tuples, but there are 72 cells"));
  filter->SetMaterialArrayName(nullptr);
  filter->SetFixedPointArrayName("Fixed");
  CHECK_EQUAL(Update(filter, plate), 0);
  CHECK(errors.Said("no numeric point array \"Fixed\""));
  tooShort->SetName("Fixed");
  plate->GetPointData()->AddArray(tooShort);
  CHECK_EQUAL(Update(filter, plate), 0);
  CHECK(errors.Said("\"Fixed\" has 1 tuples of 1 components, but 49 of 1 or 4 are needed"));
  filter->SetFixedPointArrayName(nullptr);
  plate->GetPointData()->RemoveArray("Fixed");
  tooShort->SetName("Stuff");
  CHECK_GREATER(Update(filter, plate), 0);
  CHECK(errors.Warned("\"Stuff\" has too few tuples"));
  CHECK(filter->GetOutput()->GetCellData()->GetArray("Material") != nullptr);
  plate->GetCellData()->RemoveArray("Stuff");
  plate->GetPointData()->AddArray(tooShort);
  CHECK_GREATER(Update(filter, plate), 0);
  CHECK(errors.Warned("\"Stuff\" has too few tuples"));
  CHECK(filter->GetOutput()->GetPointData()->GetArray("Stuff") == nullptr);
}

void CheckCells(RelevoCheck& check)
{
  vtkNew<vtkMicroMeshFilter> filter;
  RelevoErrors errors(filter);
  filter->SetTolerance(0.01);
  CHECK_EQUAL(Update(filter, vtkNew<vtkPolyData>()), 0);
  CHECK(errors.None());
  const Mesh missing = Plate(4);
  const vtkIdType corners[3] = { 0, 1, 1000 };
  missing->GetPolys()->InsertNextCell(3, corners);
  CHECK_EQUAL(Update(filter, missing), 0);
  CHECK(errors.Said("Cell 32 of the input refers to point 1000, but there are 25 points"));
  const Mesh infinite = Plate(4);
  infinite->GetPoints()->SetPoint(7, 0.0, std::nan(""), 0.0);
  CHECK_EQUAL(Update(filter, infinite), 0);
  CHECK(errors.Said("Point 7 of the input"));
  const Mesh repeated = Plate(4);
  repeated->GetCellData()->Initialize();
  const vtkIdType cells[3][3] = { { 0, 1, 1 }, { 1, 6, 0 }, { 0, 1, 6 } };
  for (const vtkIdType* cell : cells)
  {
    repeated->GetPolys()->InsertNextCell(3, cell);
  }
  CHECK_GREATER(Update(filter, repeated), 0);
  CHECK(errors.Warned("1 triangles with coincident corners are left out"));
  const Mesh twice = Plate(4);
  twice->GetCellData()->Initialize();
  twice->GetPolys()->InsertNextCell({ 6, 0, 1 }); // cell 0 with its corners rotated
  CHECK_GREATER(Update(filter, twice), 0);
  CHECK(errors.Warned("1 duplicates of triangles are left out"));
  const Mesh lines = Plate(4);
  lines->SetLines(lines->GetPolys());
  lines->SetPolys(vtkNew<vtkCellArray>());
  lines->GetCellData()->Initialize();
  CHECK_EQUAL(Update(filter, lines), 0);
  CHECK(errors.None());
}

// Reverses the order of points of every nth triangle.
Mesh Reversed(const Mesh& mesh, int n)
{
  vtkNew<vtkCellArray> triangles;
  for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
  {
    vtkIdType size;
    const vtkIdType* ids;
    mesh->GetCellPoints(i, size, ids);
    const bool isReversed = i % n == 0;
    triangles->InsertNextCell({ ids[0], ids[isReversed ? 2 : 1], ids[isReversed ? 1 : 2] });
  }
  const auto reversed = Mesh::New();
  reversed->SetPoints(mesh->GetPoints());
  reversed->SetPolys(triangles);
  return reversed;
}

// Each triangle has points of its own.
Mesh Soup(vtkPolyData* mesh)
{
  std::vector<std::array<double, 3>> points;
  std::vector<RelevoMeshes::Triangle> triangles;
  for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
  {
    vtkIdType size;
    const vtkIdType* ids;
    mesh->GetCellPoints(i, size, ids);
    for (int c = 0; c < 3; ++c)
    {
      points.emplace_back();
      mesh->GetPoint(ids[c], points.back().data());
    }
    triangles.push_back({ { 3 * i, 3 * i + 1, 3 * i + 2 } });
  }
  return RelevoMeshes::FromTriangles(points, triangles);
}

Mesh Both(vtkPolyData* one, vtkPolyData* other)
{
  vtkNew<vtkAppendPolyData> both;
  both->AddInputData(one);
  both->AddInputData(other);
  both->Update();
  return both->GetOutput();
}

void CheckTolerance(RelevoCheck& check, const std::string& name, vtkPolyData* mesh, double share)
{
  CHECK_CASE(name);
  vtkNew<vtkMicroMeshFilter> filter;
  RelevoErrors errors(filter); // warnings are expected
  const double tolerance = share * mesh->GetLength();
  filter->SetTolerance(tolerance);
  filter->SetTargetReduction(1.0);
  filter->SetMaximumLevel(3);
  CHECK_GREATER(Update(filter, mesh), 0);
  CHECK_LESS_EQUAL(filter->GetError(), tolerance);
  if (mesh->GetLength() > 1e20)
  {
    return; // curved faces do not fit into floats
  }
  const Mesh result = Decode(filter->GetOutput(), 3);
  const double rounding = 1e-6 * mesh->GetLength();
  CHECK_LESS_EQUAL(GetDistance(result, mesh), filter->GetError() + rounding);
  CHECK_LESS_EQUAL(GetDistance(mesh, result), filter->GetError() + rounding);
}
}

int TestMicroMeshFilterErrors(int, char*[])
{
  RelevoCheck check;
  CheckSettings(check);
  CheckArrays(check);
  CheckCells(check);
  using namespace RelevoMeshes;
  CheckTolerance(check, "triangle",
    FromTriangles({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, { { 0, 1, 2 } }), 0.01);
  CheckTolerance(check, "non-manifold", NonManifold(), 0.01);
  CheckTolerance(check, "Moebius", Moebius(), 0.01);
  CheckTolerance(check, "slivers", Slivers(), 0.01);
  const double nowhere[3] = { 0.0, 0.0, 0.0 };
  const double far[3] = { 5e6, -4e6, 1e5 };
  CheckTolerance(check, "huge", Moved(Torus(), 1e30, nowhere, VTK_DOUBLE), 0.01);
  CheckTolerance(check, "tiny", Moved(Torus(), 1e-20, nowhere, VTK_DOUBLE), 0.01);
  CheckTolerance(check, "far", Moved(Torus(), 1.0, far, VTK_DOUBLE), 0.01);
  CheckTolerance(check, "small tolerance", Torus(), 1e-7);
  // The two sides of a thin plate are close to each other.
  Mesh thin = Sphere(40, 20);
  for (vtkIdType i = 0; i < thin->GetNumberOfPoints(); ++i)
  {
    double x[3];
    thin->GetPoint(i, x);
    thin->GetPoints()->SetPoint(i, x[0], x[1], 0.01 * x[2]);
  }
  CheckTolerance(check, "thin", thin, 0.001);
  const double aside[3] = { 0.3, 0.2, 0.1 };
  const Mesh sphere = Sphere(24, 12);
  CheckTolerance(
    check, "self-intersecting", Both(sphere, Moved(sphere, 1.0, aside, VTK_FLOAT)), 0.005);
  CheckTolerance(check, "inconsistent winding", Reversed(sphere, 7), 0.005);
  CheckTolerance(check, "half of the winding reversed", Reversed(sphere, 2), 0.005);
  CheckTolerance(check, "soup", Soup(Plate(6)), 0.01);
  // Two fans share a vertex only, and a duplicate of the sphere has other points.
  CheckTolerance(check, "non-manifold vertex",
    FromTriangles({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { -1, 0, 1 }, { 0, -1, 1 } },
      { { 0, 1, 2 }, { 0, 3, 4 } }),
    0.01);
  CheckTolerance(check, "coincident sheets", Both(sphere, Reversed(sphere, 1)), 0.005);
  const Mesh outlier = Moved(sphere, 1.0, nowhere, VTK_DOUBLE);
  outlier->GetPoints()->SetPoint(5, 1e30, 0.0, 0.0);
  outlier->GetPoints()->Modified();
  CheckTolerance(check, "outlier", outlier, 1e-9);
  return check.GetResult();
}
