// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves that linear cells of every kind are split into tetrahedra that fill the mesh, with the
// same triangles on both sides of a shared face.
#include "Bezier/SplitCounts.h"
#include "Cells/VolumeCells.h"
#include "RelevoCheck.h"
#include "RelevoDice.h"
#include "RelevoMixedCells.h"
#include "RelevoVolumes.h"

#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkQuadraticHexahedron.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace
{
using relevo::dvec3;
using relevo::VolumeCells;

constexpr int Size = 5;             // cubes per axis
constexpr int Side = Size + 1;      // points
constexpr double Jitter = 0.08;     // as a share of a cube's side
constexpr int BorderTriangles = 12; // a cube of side 1 has this many

void Add(VolumeCells& cells, vtkDataSet* mesh)
{
  vtkNew<vtkDoubleArray> scalars;
  scalars->SetNumberOfValues(mesh->GetNumberOfPoints());
  scalars->FillValue(1.0);
  cells.Add(mesh, scalars, false, {});
  cells.ConvertCurved();
}

// The number of triangles that belong to one tetrahedron, by coordinates. Returns 0 if a triangle
// belongs to three.
size_t CountBorder(const VolumeCells& cells)
{
  std::map<std::array<std::array<double, 3>, 3>, int> triangles;
  for (const VolumeCells::Cell& cell : cells.GetCells())
  {
    const relevo::TetrahedronCorners corners = cells.GetTetrahedron(cell);
    for (int left = 0; left < 4; ++left)
    {
      std::array<std::array<double, 3>, 3> triangle;
      for (int i = 0; i < 3; ++i)
      {
        const dvec3& corner = corners[(left + 1 + i) % 4];
        triangle[i] = { { corner.x, corner.y, corner.z } };
      }
      std::sort(triangle.begin(), triangle.end());
      ++triangles[triangle];
    }
  }
  size_t count = 0;
  for (const auto& triangle : triangles)
  {
    if (triangle.second > 2)
    {
      return 0;
    }
    count += triangle.second == 1 ? 1 : 0;
  }
  return count;
}

double SumVolumes(const VolumeCells& cells)
{
  double sum = 0.0;
  for (const VolumeCells::Cell& cell : cells.GetCells())
  {
    const relevo::TetrahedronCorners corners = cells.GetTetrahedron(cell);
    sum += std::abs(dot(
             corners[1] - corners[0], cross(corners[2] - corners[0], corners[3] - corners[0]))) /
      6.0;
  }
  return sum;
}

void TestMixed(RelevoCheck& check)
{
  for (unsigned int seed = 1; seed <= 4; ++seed)
  {
    VolumeCells cells;
    cells.SplitAll();
    Add(cells, MakeMixedCells(Size, seed, Jitter));
    CHECK_EQUAL(CountBorder(cells), static_cast<size_t>(BorderTriangles * Size * Size));
    CHECK_NEAR(SumVolumes(cells), 1.0, 1e-12);
  }
}

// The same cells with points in another order. Polyhedra become hexahedra.
vtkSmartPointer<vtkUnstructuredGrid> Renumber(vtkUnstructuredGrid* mesh)
{
  RelevoDice dice(5);
  std::vector<vtkIdType> numbers(static_cast<size_t>(mesh->GetNumberOfPoints()));
  std::iota(numbers.begin(), numbers.end(), 0);
  for (size_t i = numbers.size() - 1; i > 0; --i)
  {
    std::swap(numbers[i], numbers[static_cast<size_t>(dice.Throw(static_cast<int>(i + 1)))]);
  }
  auto result = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(mesh->GetNumberOfPoints());
  for (size_t i = 0; i < numbers.size(); ++i)
  {
    points->SetPoint(numbers[i], mesh->GetPoint(static_cast<vtkIdType>(i)));
  }
  result->SetPoints(points);
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
  {
    mesh->GetCellPoints(i, ids);
    const int type = mesh->GetCellType(i);
    std::vector<vtkIdType> others;
    for (vtkIdType id : *ids)
    {
      others.push_back(numbers[static_cast<size_t>(id)]);
    }
    result->InsertNextCell(type == VTK_POLYHEDRON ? VTK_HEXAHEDRON : type,
      static_cast<vtkIdType>(others.size()), others.data());
  }
  return result;
}

// Adjacent blocks with different point ids.
void TestBlocks(RelevoCheck& check)
{
  VolumeCells cells;
  cells.SplitAll();
  Add(cells, MakeMixedCells(Size, 1, Jitter));
  const auto mesh = MakeMixedCells(Size, 2, Jitter, 1.0);
  vtkPoints* points = mesh->GetPoints();
  const auto other = MakeMixedCells(Size, 1, Jitter);
  for (int n = 0; n < Side * Side; ++n)
  {
    // Both blocks have this point on the common face.
    double place[3];
    other->GetPoint(Size + Side * n, place);
    points->SetPoint(Side * n, place);
  }
  const auto numbered = Renumber(mesh);
  Add(cells, numbered);
  CHECK_EQUAL(
    CountBorder(cells), static_cast<size_t>(2 * BorderTriangles * Size * Size - 4 * Size * Size));
  CHECK_NEAR(SumVolumes(cells), 2.0, 1e-12);
}

void TestVoxels(RelevoCheck& check)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(4, 4, 4);
  VolumeCells cells;
  cells.SplitAll();
  Add(cells, image);
  CHECK_EQUAL(cells.GetCells().size(), 27 * 6);
  CHECK_EQUAL(CountBorder(cells), BorderTriangles * 9);
  CHECK_NEAR(SumVolumes(cells), 27.0, 1e-12);
}

void TestPrism(RelevoCheck& check)
{
  vtkNew<vtkUnstructuredGrid> mesh;
  vtkNew<vtkPoints> points;
  constexpr double quarter = 1.5707963267948966;
  for (int i = 0; i < 12; ++i)
  {
    const double angle = 2.0 / 3.0 * quarter * i;
    points->InsertNextPoint(std::cos(angle), std::sin(angle), i / 6);
  }
  mesh->SetPoints(points);
  const vtkIdType ids[12] = { 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11 };
  mesh->InsertNextCell(VTK_HEXAGONAL_PRISM, 12, ids);
  VolumeCells cells;
  Add(cells, mesh);
  CHECK_EQUAL(CountBorder(cells), 2 * 4 + 6 * 2);
  CHECK_NEAR(SumVolumes(cells), 1.5 * std::sqrt(3.0), 1e-6);
}

void TestCurved(RelevoCheck& check)
{
  vtkNew<vtkQuadraticHexahedron> cell;
  vtkNew<vtkUnstructuredGrid> mesh;
  vtkNew<vtkPoints> points;
  const double* places = cell->GetParametricCoords();
  std::array<vtkIdType, 20> ids;
  for (int i = 0; i < 20; ++i)
  {
    ids[i] = points->InsertNextPoint(places + 3 * i);
  }
  mesh->SetPoints(points);
  mesh->InsertNextCell(VTK_QUADRATIC_HEXAHEDRON, 20, ids.data());
  VolumeCells cells;
  cells.SplitAll();
  Add(cells, mesh);
  relevo::SplitTolerances tolerances = { 1e-3, {} };
  tolerances.Values.fill(1.0);
  CHECK_EQUAL(cells.SplitCurved(tolerances), true);
  CHECK_NEAR(SumVolumes(cells), 1.0, 1e-6);
}
}

int TestCellSplitter(int, char*[])
{
  RelevoCheck check;
  TestMixed(check);
  TestBlocks(check);
  TestVoxels(check);
  TestPrism(check);
  TestCurved(check);
  return check.GetResult();
}
