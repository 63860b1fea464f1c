// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RelevoMixedCells.h"

#include "RelevoDice.h"

#include "vtkCellType.h"
#include "vtkNew.h"
#include "vtkPoints.h"

#include <algorithm>

namespace
{
using Corners = std::array<vtkIdType, 8>;

// A cube with this many points per axis.
Corners GetCube(int i, int j, int k, int side)
{
  const vtkIdType low = i + side * (j + side * k);
  const vtkIdType high = low + side * side;
  return { { low, low + 1, low + side + 1, low + side, high, high + 1, high + side + 1,
    high + side } };
}

// The same hexahedron with another first corner.
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
  double middle[3] = { 0.0, 0.0, 0.0 };
  for (vtkIdType corner : cube)
  {
    double place[3];
    mesh->GetPoint(corner, place);
    for (int c = 0; c < 3; ++c)
    {
      middle[c] += 0.125 * place[c];
    }
  }
  const vtkIdType top = mesh->GetPoints()->InsertNextPoint(middle);
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
}

vtkSmartPointer<vtkUnstructuredGrid> MakeMixedCells(
  int n, unsigned int seed, double share, double x)
{
  const int side = n + 1;
  RelevoDice dice(seed);
  auto mesh = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  mesh->SetPoints(points);
  for (int i = 0; i < side * side * side; ++i)
  {
    const int at[3] = { i % side, i / side % side, i / side / side };
    double place[3];
    for (int c = 0; c < 3; ++c)
    {
      const bool isInner = at[c] > 0 && at[c] < n;
      place[c] = (at[c] + (isInner ? share * dice.Signed() : 0.0)) / n;
    }
    points->InsertNextPoint(place[0] + x, place[1], place[2]);
  }
  for (int column = 0; column < n * n; ++column)
  {
    const bool isOfWedges = dice.Once(4);
    for (int k = 0; k < n; ++k)
    {
      const Corners cube = GetCube(column % n, column / n, k, side);
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
