// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkPatchReference.h"

#include "vtkDataArray.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkStaticPointLocator.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
constexpr int NodesOfCell = 64;
// Tolerance for hits outside a face, relative to its width, where its neighbours continue.
constexpr double Outside = 0.02;
}

BenchmarkPatchReference::BenchmarkPatchReference(vtkUnstructuredGrid* grid)
  : Grid(grid)
  , Side(std::lround(std::cbrt(grid->GetNumberOfCells())))
{
  this->Nodes->SetDataSet(grid);
  this->Nodes->BuildLocator();
}

BenchmarkPatchReference::~BenchmarkPatchReference() = default;

BenchmarkPatchReference::Place BenchmarkPatchReference::Evaluate(
  const Place& parametric, double weights[])
{
  Place x;
  int subId = 0;
  this->Cell->EvaluateLocation(subId, parametric.data(), x.data(), weights);
  return x;
}

BenchmarkPatchReference::Hit BenchmarkPatchReference::MeetFace(
  const Place& eye, const Place& point, int axis, bool atEnd)
{
  const int along[2] = { (axis + 1) % 3, (axis + 2) % 3 };
  Place place = { { 0.5, 0.5, 0.5 } };
  place[axis] = atEnd ? 1.0 : 0.0;
  Hit hit;
  hit.Parameter = 1.0;
  double weights[NodesOfCell];
  for (int step = 0; step < 20 && !hit.IsFound; ++step)
  {
    constexpr double difference = 1e-6;
    const Place x = this->Evaluate(place, weights);
    double columns[3][3]; // the derivatives
    double rest[3];
    for (int c = 0; c < 3; ++c)
    {
      columns[2][c] = eye[c] - point[c];
      rest[c] = eye[c] + hit.Parameter * (point[c] - eye[c]) - x[c];
    }
    double unused[NodesOfCell];
    for (int k = 0; k < 2; ++k)
    {
      Place moved = place;
      moved[along[k]] += difference;
      moved = this->Evaluate(moved, unused);
      for (int c = 0; c < 3; ++c)
      {
        columns[k][c] = (moved[c] - x[c]) / difference;
      }
    }
    const double determinant = vtkMath::Determinant3x3(columns[0], columns[1], columns[2]);
    const double u = vtkMath::Determinant3x3(rest, columns[1], columns[2]) / determinant;
    const double v = vtkMath::Determinant3x3(columns[0], rest, columns[2]) / determinant;
    place[along[0]] += u;
    place[along[1]] += v;
    hit.Parameter += vtkMath::Determinant3x3(columns[0], columns[1], rest) / determinant;
    hit.IsFound = std::abs(u) + std::abs(v) < 1e-7;
  }
  for (const int k : along)
  {
    hit.IsFound = hit.IsFound && place[k] >= -Outside && place[k] <= 1.0 + Outside;
  }
  this->Evaluate(place, weights);
  for (int i = 0; i < NodesOfCell; ++i)
  {
    hit.Value += weights[i] *
      this->Grid->GetPointData()->GetScalars()->GetComponent(this->Cell->GetPointId(i), 0);
  }
  return hit;
}

BenchmarkPatchReference::Hit BenchmarkPatchReference::MeetCell(
  const Place& eye, const Place& point, vtkIdType cell)
{
  this->Grid->GetCell(cell, this->Cell);
  const vtkIdType indices[3] = { cell % this->Side, cell / this->Side % this->Side,
    cell / (this->Side * this->Side) };
  Hit nearest;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const bool atEnd : { false, true })
    {
      if (indices[axis] == (atEnd ? this->Side - 1 : 0))
      {
        nearest = Choose(nearest, this->MeetFace(eye, point, axis, atEnd));
      }
    }
  }
  return nearest;
}

BenchmarkPatchReference::Hit BenchmarkPatchReference::Choose(const Hit& first, const Hit& second)
{
  const bool isNearer =
    !first.IsFound || std::abs(second.Parameter - 1.0) < std::abs(first.Parameter - 1.0);
  return second.IsFound && isNearer ? second : first;
}

double BenchmarkPatchReference::FindValue(const Place& eye, const Place& point)
{
  this->Grid->GetPointCells(this->Nodes->FindClosestPoint(point.data()), this->CellsAtNode);
  Hit nearest;
  for (vtkIdType i = 0; i < this->CellsAtNode->GetNumberOfIds(); ++i)
  {
    nearest = Choose(nearest, this->MeetCell(eye, point, this->CellsAtNode->GetId(i)));
  }
  return nearest.IsFound ? nearest.Value : std::numeric_limits<double>::quiet_NaN();
}
