// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RelevoVisibility.h"

#include "vtkCell.h"
#include "vtkCellType.h"
#include "vtkDataSet.h"
#include "vtkGenericCell.h"
#include "vtkIdTypeArray.h"
#include "vtkMath.h"
#include "vtkMeshVisibilitySort.h"
#include "vtkNew.h"
#include "vtkPoints.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>

namespace
{
// Relative to the mesh's diagonal. Shorter parts of rays are ignored.
constexpr double Shortest = 1e-8;

// A plane through the corners of a face with straight edges. Corners may be collinear.
std::array<double, 4> MakePlane(vtkCell* face, const RelevoPoint& inside)
{
  std::vector<RelevoPoint> corners(face->GetNumberOfEdges());
  for (size_t i = 0; i < corners.size(); ++i)
  {
    face->GetPoints()->GetPoint(static_cast<vtkIdType>(i), corners[i].data());
  }
  if (face->GetCellType() == VTK_PIXEL)
  {
    std::swap(corners[2], corners[3]);
  }
  std::array<double, 4> plane = { { 0.0, 0.0, 0.0, 0.0 } };
  for (size_t i = 1; i + 1 < corners.size(); ++i)
  {
    RelevoPoint a;
    RelevoPoint b;
    RelevoPoint normal;
    vtkMath::Subtract(corners[i].data(), corners[0].data(), a.data());
    vtkMath::Subtract(corners[i + 1].data(), corners[0].data(), b.data());
    vtkMath::Cross(a.data(), b.data(), normal.data());
    std::transform(normal.begin(), normal.end(), plane.begin(), plane.begin(), std::plus<double>());
  }
  vtkMath::Normalize(plane.data());
  plane[3] = -vtkMath::Dot(plane.data(), corners[0].data());
  if (vtkMath::Dot(plane.data(), inside.data()) + plane[3] < 0.0)
  {
    std::transform(plane.begin(), plane.end(), plane.begin(), [](double x) { return -x; });
  }
  return plane;
}
}

std::vector<vtkIdType> Traverse(vtkVisibilitySort* sort)
{
  std::vector<vtkIdType> cells;
  sort->InitTraversal();
  while (vtkIdTypeArray* next = sort->GetNextCells())
  {
    for (vtkIdType i = 0; i < next->GetNumberOfTuples(); ++i)
    {
      cells.push_back(next->GetValue(i));
    }
  }
  return cells;
}

bool IsEachOnce(vtkDataSet* mesh, const std::vector<vtkIdType>& cells)
{
  std::vector<vtkIdType> expected;
  vtkNew<vtkGenericCell> cell;
  for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
  {
    mesh->GetCell(i, cell);
    if (cell->GetCellDimension() == 3)
    {
      expected.push_back(i);
    }
  }
  std::vector<vtkIdType> sorted = cells;
  std::sort(sorted.begin(), sorted.end());
  return sorted == expected;
}

RelevoConvexCells::RelevoConvexCells(vtkDataSet* mesh)
{
  double bounds[6];
  mesh->GetBounds(bounds);
  this->Low = { { bounds[0], bounds[2], bounds[4] } };
  this->High = { { bounds[1], bounds[3], bounds[5] } };
  this->Diagonal = mesh->GetLength();
  vtkNew<vtkGenericCell> cell;
  for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
  {
    mesh->GetCell(i, cell);
    double box[6];
    cell->GetBounds(box);
    const double sides[3] = { box[1] - box[0], box[3] - box[2], box[5] - box[4] };
    Cell convex = { { { 0.0, 0.0, 0.0 } }, vtkMath::Norm(sides), {} };
    const int size = static_cast<int>(cell->GetNumberOfPoints());
    for (int point = 0; point < size; ++point)
    {
      double x[3];
      cell->GetPoints()->GetPoint(point, x);
      for (int c = 0; c < 3; ++c)
      {
        convex.Center[c] += x[c] / size;
      }
    }
    for (int face = 0; face < cell->GetNumberOfFaces(); ++face)
    {
      convex.Planes.push_back(MakePlane(cell->GetFace(face), convex.Center));
    }
    this->Cells.push_back(convex);
  }
}

// Parts with parameters from 0 at the beginning to 1 at the end.
std::vector<RelevoConvexCells::Part> RelevoConvexCells::Cross(
  const RelevoPoint& begin, const RelevoPoint& end) const
{
  RelevoPoint along;
  vtkMath::Subtract(end.data(), begin.data(), along.data());
  const double size = vtkMath::Norm(along.data());
  std::vector<Part> parts;
  for (size_t i = 0; i < this->Cells.size(); ++i)
  {
    const Cell& cell = this->Cells[i];
    RelevoPoint to;
    RelevoPoint aside;
    vtkMath::Subtract(cell.Center.data(), begin.data(), to.data());
    vtkMath::Cross(to.data(), along.data(), aside.data());
    if (cell.Planes.empty() || vtkMath::Norm(aside.data()) > cell.Radius * size)
    {
      continue;
    }
    Part part = { 0.0, 1.0, static_cast<vtkIdType>(i) };
    for (const auto& plane : cell.Planes)
    {
      const double first = vtkMath::Dot(plane.data(), begin.data()) + plane[3];
      const double change = vtkMath::Dot(plane.data(), along.data());
      const double at = -first / change;
      part.Begin = change > 0.0 ? std::max(part.Begin, at) : part.Begin;
      part.End = change < 0.0 ? std::min(part.End, at) : part.End;
      part.End = change == 0.0 && first <= 0.0 ? 0.0 : part.End;
    }
    if ((part.End - part.Begin) * size > Shortest * this->Diagonal)
    {
      parts.push_back(part);
    }
  }
  std::sort(
    parts.begin(), parts.end(), [](const Part& a, const Part& b) { return a.Begin < b.Begin; });
  return parts;
}

RelevoPairs RelevoConvexCells::Compare(const std::vector<vtkIdType>& cells,
  const std::array<double, 4>& eye, int numberOfRays, RelevoDice& dice) const
{
  std::vector<size_t> places(this->Cells.size(), 0);
  for (size_t i = 0; i < cells.size(); ++i)
  {
    places[cells[i]] = i;
  }
  RelevoPairs pairs;
  for (int ray = 0; ray < numberOfRays; ++ray)
  {
    RelevoPoint begin;
    RelevoPoint end;
    for (int c = 0; c < 3; ++c)
    {
      const double target = this->Low[c] + dice.Share() * (this->High[c] - this->Low[c]);
      begin[c] = eye[3] == 0.0 ? target + 2.0 * this->Diagonal * eye[c] : eye[c];
      end[c] = begin[c] + 4.0 * (target - begin[c]);
    }
    const std::vector<Part> parts = this->Cross(begin, end);
    const double step = std::sqrt(vtkMath::Distance2BetweenPoints(begin.data(), end.data()));
    for (size_t i = 1; i < parts.size(); ++i)
    {
      // Overlapping cells have no order.
      if ((parts[i].Begin - parts[i - 1].End) * step > -Shortest * this->Diagonal)
      {
        pairs.All++;
        pairs.Wrong += places[parts[i].Cell] > places[parts[i - 1].Cell] ? 1 : 0;
      }
    }
  }
  return pairs;
}

RelevoPairs CountPairs(RelevoCheck& check, const std::string& name, vtkUnstructuredGrid* mesh,
  RelevoDice& dice, int numberOfRays)
{
  const RelevoConvexCells cells(mesh);
  double middle[3];
  mesh->GetCenter(middle);
  vtkNew<vtkMeshVisibilitySort> sort;
  sort->SetInput(mesh);
  RelevoPairs pairs;
  for (int view = 0; view < 6; ++view)
  {
    const double away = mesh->GetLength();
    const auto camera =
      MakeCamera({ { middle[0] + away * dice.Signed(), middle[1] + away * dice.Signed(),
                   middle[2] + away * dice.Signed() } },
        { { middle[0], middle[1], middle[2] } });
    sort->SetCamera(camera);
    const std::vector<vtkIdType> order = Traverse(sort);
    CHECK(IsEachOnce(mesh, order));
    CHECK_EQUAL(sort->GetNumberOfCycles(), 0);
    const double* eye = camera->GetPosition();
    const RelevoPairs more =
      cells.Compare(order, { { eye[0], eye[1], eye[2], 1.0 } }, numberOfRays, dice);
    pairs.All += more.All;
    pairs.Wrong += more.Wrong;
  }
  CHECK_GREATER(pairs.All, numberOfRays);
  std::cout << name << ": " << pairs.Wrong << " of " << pairs.All << " pairs are wrong\n";
  return pairs;
}
