// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Cells of every linear kind, split: the tetrahedra fill the mesh, and those of cells that share a
// face have the same triangles there.
#include "Cells/VolumeCells.h"
#include "RelevoCheck.h"
#include "RelevoDice.h"
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

namespace
{
using relevo::dvec3;
using relevo::VolumeCells;

constexpr int Size = 5;             // cubes each way
constexpr int Side = Size + 1;      // points
constexpr double Jitter = 0.08;     // of the side of a cube
constexpr int BorderTriangles = 12; // of a cube of side 1

using Corners = std::array<vtkIdType, 8>;

vtkIdType GetPoint(int i, int j, int k)
{
  return i + Side * (j + Side * k);
}

Corners GetCube(int i, int j, int k)
{
  return { { GetPoint(i, j, k), GetPoint(i + 1, j, k), GetPoint(i + 1, j + 1, k),
    GetPoint(i, j + 1, k), GetPoint(i, j, k + 1), GetPoint(i + 1, j, k + 1),
    GetPoint(i + 1, j + 1, k + 1), GetPoint(i, j + 1, k + 1) } };
}

// The same hexahedron by other corners first.
Corners Turn(Corners cube, RelevoDice& dice)
{
  constexpr Corners turns[2] = { { { 1, 2, 3, 0, 5, 6, 7, 4 } }, { { 3, 2, 6, 7, 0, 1, 5, 4 } } };
  for (int n = dice.Throw(8); n > 0; --n)
  {
    const Corners& turn = turns[dice.Throw(2)];
    const Corners before = cube;
    std::transform(turn.begin(), turn.end(), cube.begin(), [&](vtkIdType i) { return before[i]; });
  }
  return cube;
}

constexpr int CubeFaces[6][4] = { { 0, 4, 7, 3 }, { 1, 2, 6, 5 }, { 0, 1, 5, 4 }, { 3, 7, 6, 2 },
  { 0, 3, 2, 1 }, { 4, 5, 6, 7 } };

void AddPyramids(vtkUnstructuredGrid* mesh, const Corners& cube, RelevoDice& dice)
{
  dvec3 middle(0.0);
  for (vtkIdType corner : cube)
  {
    dvec3 place;
    mesh->GetPoint(corner, &place.x);
    middle += 0.125 * place;
  }
  const vtkIdType top = mesh->GetPoints()->InsertNextPoint(middle.x, middle.y, middle.z);
  for (const auto& face : CubeFaces)
  {
    const int first = dice.Throw(4);
    vtkIdType ids[5];
    for (int i = 0; i < 4; ++i)
    {
      ids[i] = cube[face[(first + i) % 4]];
    }
    ids[4] = top;
    mesh->InsertNextCell(VTK_PYRAMID, 5, ids);
  }
}

void AddPolyhedron(vtkUnstructuredGrid* mesh, const Corners& cube)
{
  std::vector<vtkIdType> faces;
  for (const auto& face : CubeFaces)
  {
    faces.push_back(4);
    for (int corner : face)
    {
      faces.push_back(cube[corner]);
    }
  }
  mesh->InsertNextCell(VTK_POLYHEDRON, 8, cube.data(), 6, faces.data());
}

void AddWedges(vtkUnstructuredGrid* mesh, const Corners& cube, RelevoDice& dice)
{
  constexpr int halves[2][3] = { { 0, 1, 2 }, { 0, 2, 3 } };
  for (const auto& half : halves)
  {
    const int first = dice.Throw(3);
    vtkIdType ids[6];
    for (int i = 0; i < 6; ++i)
    {
      ids[i] = cube[half[(first + i) % 3] + (i < 3 ? 0 : 4)];
    }
    mesh->InsertNextCell(VTK_WEDGE, 6, ids);
  }
}

// Cubes with bent faces, plane at the border, as cells of all kinds, whose points are in any order.
vtkSmartPointer<vtkUnstructuredGrid> MakeMixed(unsigned int seed, double x = 0.0)
{
  RelevoDice dice(seed);
  auto mesh = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  mesh->SetPoints(points);
  for (int n = 0; n < Side * Side * Side; ++n)
  {
    const int at[3] = { n % Side, n / Side % Side, n / Side / Side };
    double place[3];
    for (int c = 0; c < 3; ++c)
    {
      const bool isInner = at[c] > 0 && at[c] < Size;
      place[c] = (at[c] + (isInner ? Jitter * dice.Signed() : 0.0)) / Size;
    }
    points->InsertNextPoint(place[0] + x, place[1], place[2]);
  }
  for (int column = 0; column < Size * Size; ++column)
  {
    const bool isOfWedges = dice.Once(4);
    for (int k = 0; k < Size; ++k)
    {
      const Corners cube = GetCube(column % Size, column / Size, k);
      const int kind = dice.Throw(4);
      if (isOfWedges)
      {
        AddWedges(mesh, cube, dice);
      }
      else if (kind == 0)
      {
        AddPyramids(mesh, cube, dice);
      }
      else if (kind == 1)
      {
        AddPolyhedron(mesh, Turn(cube, dice));
      }
      else
      {
        mesh->InsertNextCell(VTK_HEXAHEDRON, 8, Turn(cube, dice).data());
      }
    }
  }
  return mesh;
}

void Add(VolumeCells& cells, vtkDataSet* mesh)
{
  vtkNew<vtkDoubleArray> scalars;
  scalars->SetNumberOfValues(mesh->GetNumberOfPoints());
  scalars->FillValue(1.0);
  cells.Add(mesh, scalars, false, {});
}

// How many triangles belong to one tetrahedron, by their places; 0 if one belongs to three.
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
    Add(cells, MakeMixed(seed));
    CHECK(CountBorder(cells) == static_cast<size_t>(BorderTriangles * Size * Size));
    CHECK_NEAR(SumVolumes(cells), 1.0, 1e-12);
  }
}

// Blocks side by side, whose points have other numbers.
void TestBlocks(RelevoCheck& check)
{
  VolumeCells cells;
  cells.SplitAll();
  Add(cells, MakeMixed(1));
  const auto mesh = MakeMixed(2, 1.0);
  vtkPoints* points = mesh->GetPoints();
  const auto other = MakeMixed(1);
  for (int n = 0; n < Side * Side; ++n)
  {
    // The same places in the common face.
    double place[3];
    other->GetPoint(GetPoint(Size, n % Side, n / Side), place);
    points->SetPoint(GetPoint(0, n % Side, n / Side), place);
  }
  vtkNew<vtkUnstructuredGrid> turned;
  const vtkIdType last = mesh->GetNumberOfPoints() - 1;
  vtkNew<vtkPoints> backwards;
  backwards->SetDataTypeToDouble();
  for (vtkIdType i = 0; i <= last; ++i)
  {
    backwards->InsertNextPoint(mesh->GetPoint(last - i));
  }
  turned->SetPoints(backwards);
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
  {
    mesh->GetCellPoints(i, ids);
    const int type = mesh->GetCellType(i);
    std::vector<vtkIdType> opposite;
    for (vtkIdType id : *ids)
    {
      opposite.push_back(last - id);
    }
    type == VTK_POLYHEDRON ? turned->InsertNextCell(VTK_HEXAHEDRON, 8, opposite.data())
                           : turned->InsertNextCell(type, ids->GetNumberOfIds(), opposite.data());
  }
  Add(cells, turned);
  CHECK(
    CountBorder(cells) == static_cast<size_t>(2 * BorderTriangles * Size * Size - 4 * Size * Size));
  CHECK_NEAR(SumVolumes(cells), 2.0, 1e-12);
}

void TestVoxels(RelevoCheck& check)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(4, 4, 4);
  VolumeCells cells;
  cells.SplitAll();
  Add(cells, image);
  CHECK(cells.GetCells().size() == 27 * 6);
  CHECK(CountBorder(cells) == BorderTriangles * 9);
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
  CHECK(CountBorder(cells) == 2 * 4 + 6 * 2);
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
  Add(cells, mesh);
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
