// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkPatchSurfaceFilter promises outward patches for polygons, polyhedra and inverted cells, copied
// arrays, and the curved cells of a VTK file.
#include "RelevoCheck.h"
#include "RelevoPatches.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkIntArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGridReader.h"

#include <algorithm>
#include <fstream>
#include <iostream>

namespace
{
vtkSmartPointer<vtkUnstructuredGrid> NewGrid(const std::vector<RelevoPosition>& places)
{
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const RelevoPosition& place : places)
  {
    points->InsertNextPoint(place.data());
  }
  grid->SetPoints(points);
  grid->Allocate(1);
  return grid;
}

RelevoPosition Evaluate(vtkPolyData* mesh, int patch, double u, double v)
{
  const std::vector<double> x = RelevoEvaluatePatch(mesh, patch, u, v);
  return { x[0], x[1], x[2] };
}

// For triangles of degree 1: signed areas seen along z, and the volume enclosed with the origin.
struct Sums
{
  explicit Sums(vtkPolyData* mesh)
  {
    for (int patch = 0; patch < RelevoGetNumberOfPatches(mesh); ++patch)
    {
      const RelevoPosition a = Evaluate(mesh, patch, 0.0, 0.0);
      const RelevoPosition b = Evaluate(mesh, patch, 1.0, 0.0);
      const RelevoPosition c = Evaluate(mesh, patch, 0.0, 1.0);
      const double area = 0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]));
      this->Area += area;
      this->Least = std::min(this->Least, area);
      this->Volume += vtkMath::Determinant3x3(a.data(), b.data(), c.data()) / 6.0;
    }
  }

  double Area = 0.0;
  double Least = 1.0;
  double Volume = 0.0;
};

int CountInnerBorders(vtkPolyData* mesh)
{
  vtkDataArray* borders = mesh->GetFieldData()->GetArray("PatchInnerBorders");
  int count = 0;
  for (vtkIdType i = 0; borders && i < borders->GetNumberOfTuples(); ++i)
  {
    for (int bit : { 1, 2, 4 })
    {
      count += (static_cast<int>(borders->GetTuple1(i)) & bit) != 0 ? 1 : 0;
    }
  }
  return count;
}

void TestPolygons(RelevoCheck& check)
{
  // An L-shape, which a fan from all but two of its corners would leave.
  auto grid =
    NewGrid({ { 2, 1, 0 }, { 1, 1, 0 }, { 1, 2, 0 }, { 0, 2, 0 }, { 0, 0, 0 }, { 2, 0, 0 } });
  const std::array<vtkIdType, 6> ids{ 0, 1, 2, 3, 4, 5 };
  grid->InsertNextCell(VTK_POLYGON, 6, ids.data());
  auto mesh = RelevoMakePatches(grid);
  CHECK_EQUAL(RelevoGetNumberOfPatches(mesh), 4);
  CHECK_EQUAL(mesh->GetNumberOfCells(), 4);
  CHECK_NEAR(Sums(mesh).Area, 3.0, 1e-14);
  CHECK_GREATER(Sums(mesh).Least, 0.0);
  CHECK_EQUAL(CountInnerBorders(mesh), 6); // both sides of each diagonal

  auto strip =
    NewGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 1, 1, 0 }, { 0, 2, 0 }, { 1, 2, 0 } });
  strip->InsertNextCell(VTK_TRIANGLE_STRIP, 6, ids.data());
  mesh = RelevoMakePatches(strip);
  CHECK_EQUAL(RelevoGetNumberOfPatches(mesh), 4);
  CHECK_NEAR(Sums(mesh).Area, 2.0, 1e-14);
  CHECK_GREATER(Sums(mesh).Least, 0.0);
  CHECK_EQUAL(CountInnerBorders(mesh), 0);
}

// A cube as a polyhedron with a hexahedron on top, also with the cube inside out.
void TestPolyhedra(RelevoCheck& check)
{
  std::vector<RelevoPosition> places;
  for (int k = 0; k < 12; ++k)
  {
    places.push_back({ k % 4 == 1 || k % 4 == 2 ? 1.0 : 0.0, k % 4 >= 2 ? 1.0 : 0.0, k / 4 * 1.0 });
  }
  for (bool isTurned : { false, true })
  {
    CHECK_CASE(isTurned);
    std::vector<std::vector<vtkIdType>> faces{ { 0, 4, 7, 3 }, { 1, 2, 6, 5 }, { 0, 1, 5, 4 },
      { 3, 7, 6, 2 }, { 0, 3, 2, 1 }, { 4, 5, 6, 7 } };
    vtkNew<vtkIdList> stream;
    stream->InsertNextId(6);
    for (std::vector<vtkIdType>& face : faces)
    {
      stream->InsertNextId(4);
      if (isTurned)
      {
        std::reverse(face.begin(), face.end());
      }
      for (vtkIdType point : face)
      {
        stream->InsertNextId(point);
      }
    }
    auto grid = NewGrid(places);
    grid->InsertNextCell(VTK_POLYHEDRON, stream);
    auto mesh = RelevoMakePatches(grid);
    CHECK_EQUAL(RelevoGetNumberOfPatches(mesh), 12);
    CHECK_EQUAL(CountInnerBorders(mesh), 12);
    CHECK_NEAR(Sums(mesh).Volume, 1.0, 1e-14);
    const std::array<vtkIdType, 8> upper{ 4, 5, 6, 7, 8, 9, 10, 11 };
    grid->InsertNextCell(VTK_HEXAHEDRON, 8, upper.data());
    mesh = RelevoMakePatches(grid);
    CHECK_EQUAL(RelevoGetNumberOfPatches(mesh), 10 + 5);
  }
}

// The points of this cell are ordered inside out, but its patches face outwards.
void TestTurned(RelevoCheck& check)
{
  auto grid = NewGrid({ { 0, 0, 0 }, { 0, 1, 0 }, { 1, 0, 0 }, { 0, 0, 1 } });
  const std::array<vtkIdType, 4> ids{ 0, 1, 2, 3 };
  grid->InsertNextCell(VTK_TETRA, 4, ids.data());
  CHECK_NEAR(Sums(RelevoMakePatches(grid)).Volume, 1.0 / 6.0, 1e-15);
}

void TestArrays(RelevoCheck& check)
{
  auto grid = RelevoNewCell(VTK_LAGRANGE_HEXAHEDRON, { 3, 2, 1 }, 0.05);
  vtkNew<vtkIntArray> material;
  material->SetName("Material");
  material->InsertNextValue(7);
  grid->GetCellData()->AddArray(material);
  grid->GetPointData()->SetActiveScalars("Values");
  auto mesh = RelevoMakePatches(grid);
  CHECK_EQUAL(mesh->GetNumberOfCells(), 12);
  CHECK_EQUAL(mesh->GetNumberOfPoints(), 8);
  CHECK_EQUAL(mesh->GetPoints()->GetDataType(), VTK_DOUBLE);
  CHECK_EQUAL(mesh->GetPointData()->GetScalars(), mesh->GetPointData()->GetArray("Values"));
  CHECK_EQUAL(mesh->GetPointData()->GetNormals(), mesh->GetPointData()->GetArray("Normals"));
  for (vtkIdType i = 0; i < 12; ++i)
  {
    CHECK_EQUAL(mesh->GetCellData()->GetArray("Material")->GetTuple1(i), 7.0);
    CHECK_EQUAL(mesh->GetCellData()->GetArray("vtkOriginalCellIds")->GetTuple1(i), 0.0);
  }
  for (vtkIdType i = 0; i < 8; ++i) // VTK numbers corners first
  {
    for (int c = 0; c < 2; ++c)
    {
      CHECK_EQUAL(mesh->GetPointData()->GetArray("Values")->GetComponent(i, c),
        grid->GetPointData()->GetArray("Values")->GetComponent(i, c));
    }
  }
  CHECK_EQUAL(mesh->GetFieldData()->GetArray("PatchNodes:Values")->GetNumberOfTuples(),
    mesh->GetFieldData()->GetArray("PatchPoints")->GetNumberOfTuples());
}

void TestFile(RelevoCheck& check)
{
  const char* data = std::getenv("RELEVO_TEST_DATA");
  const std::string name = std::string(data ? data : "") + "/volume/CylinderQuadratic.vtk";
  if (!std::ifstream(name))
  {
    std::cerr << "RELEVO_TEST_DATA has no volume/CylinderQuadratic.vtk\n";
    return;
  }
  vtkNew<vtkUnstructuredGridReader> reader;
  reader->SetFileName(name.c_str());
  reader->Update();
  auto mesh = RelevoMakePatches(reader->GetOutput());
  CHECK_GREATER(RelevoGetNumberOfPatches(mesh), 0);
  CHECK_NEAR(RelevoGetCellError(reader->GetOutput(), mesh) / mesh->GetLength(), 0.0, 1e-12);
}
}

int TestPatchSurfaceCells(int, char*[])
{
  RelevoCheck check;
  TestPolygons(check);
  TestPolyhedra(check);
  TestTurned(check);
  TestArrays(check);
  TestFile(check);
  return check.GetResult();
}
