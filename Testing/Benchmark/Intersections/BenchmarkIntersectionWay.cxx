// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkIntersectionWay.h"

#include "RelevoIntersections.h"

#include "Mesh/MovedSurface.h"
#include "Pairs/PairSearch.h"
#include "vtkSurfaceIntersectionFilter.h"

#include "vtkCell.h"
#include "vtkCollisionDetectionFilter.h"
#include "vtkIdTypeArray.h"
#include "vtkIntersectionPolyDataFilter.h"
#include "vtkMatrix4x4.h"
#include "vtkPolyData.h"

#include <vector>

namespace
{
using Policy = BenchmarkIntersectionWay;

// The cells of a mesh that contain both points.
std::vector<vtkIdType> FindCells(vtkPolyData* mesh, const double ends[2][3])
{
  const auto isNear = [](vtkCell* cell, const double x[3])
  {
    double closest[3], parametric[3], weights[3];
    double distance2 = 0.0;
    int subId;
    return cell->EvaluatePosition(x, closest, subId, parametric, distance2, weights) >= 0 &&
      distance2 < 1e-6;
  };
  std::vector<vtkIdType> cells;
  for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
  {
    vtkCell* cell = mesh->GetCell(i);
    if (isNear(cell, ends[0]) && isNear(cell, ends[1]))
    {
      cells.push_back(i);
    }
  }
  return cells;
}

vtkSmartPointer<vtkPolyDataAlgorithm> NewFilter(Policy::Kind kind)
{
  if (kind == Policy::Exact)
  {
    return vtkSmartPointer<vtkSurfaceIntersectionFilter>::New();
  }
  if (kind == Policy::Collisions)
  {
    auto filter = vtkSmartPointer<vtkCollisionDetectionFilter>::New();
    filter->SetCollisionModeToAllContacts();
    return filter;
  }
  auto filter = vtkSmartPointer<vtkIntersectionPolyDataFilter>::New();
  filter->SetSplitFirstOutput(kind == Policy::Splits);
  filter->SetSplitSecondOutput(kind == Policy::Splits);
  return filter;
}
}

BenchmarkIntersectionWay::BenchmarkIntersectionWay(
  Kind kind, vtkPolyData* first, vtkPolyData* second)
  : Policy(kind)
  , First(first)
  , Second(second)
  , Filter(NewFilter(kind))
{
  this->Filter->SetInputDataObject(0, first);
  this->Filter->SetInputDataObject(1, second);
  for (int i = 0; i < 2; ++i)
  {
    if (auto* exact = vtkSurfaceIntersectionFilter::SafeDownCast(this->Filter))
    {
      exact->SetMatrix(i, this->Matrices[i]);
    }
    if (auto* collisions = vtkCollisionDetectionFilter::SafeDownCast(this->Filter))
    {
      collisions->SetMatrix(i, this->Matrices[i]);
    }
  }
}

BenchmarkIntersectionWay::~BenchmarkIntersectionWay() = default;

std::string BenchmarkIntersectionWay::GetName(Kind kind)
{
  return kind == Exact   ? "vtkSurfaceIntersectionFilter"
    : kind == Collisions ? "vtkCollisionDetectionFilter"
    : kind == Lines      ? "vtkIntersectionPolyDataFilter"
                         : "the same, splitting";
}

void BenchmarkIntersectionWay::Move(vtkMatrix4x4* matrix)
{
  this->Matrices[1]->DeepCopy(matrix);
  if (this->Policy == Lines || this->Policy == Splits)
  {
    this->Filter->SetInputDataObject(1, RelevoMove(this->Second, matrix));
  }
}

void BenchmarkIntersectionWay::Update()
{
  this->Filter->Update();
}

vtkIdType BenchmarkIntersectionWay::GetNumberOfSegments() const
{
  auto* collisions = vtkCollisionDetectionFilter::SafeDownCast(this->Filter);
  return collisions ? collisions->GetNumberOfContacts()
                    : this->Filter->GetOutput()->GetNumberOfLines();
}

BenchmarkIntersectionWay::Pairs BenchmarkIntersectionWay::GetPairs() const
{
  Pairs pairs;
  if (auto* collisions = vtkCollisionDetectionFilter::SafeDownCast(this->Filter))
  {
    vtkIdTypeArray* cells[2] = { collisions->GetContactCells(0), collisions->GetContactCells(1) };
    for (int i = 0; i < collisions->GetNumberOfContacts(); ++i)
    {
      pairs.emplace(cells[0]->GetValue(i), cells[1]->GetValue(i));
    }
    return pairs;
  }
  pairs = RelevoGetCellPairs(this->Filter->GetOutput());
  if (auto* exact = vtkSurfaceIntersectionFilter::SafeDownCast(this->Filter))
  {
    // A curve has each segment once, however many pairs share it.
    pairs.merge(RelevoGetCellPairs(exact->GetOutput(1)));
    relevo::MovedSurface surfaces[2];
    relevo::Motion motions[2];
    surfaces[0].Take(this->First);
    motions[0].Set(this->Matrices[0]);
    surfaces[0].Move(motions[0]);
    surfaces[1].Take(this->Second);
    motions[1].Set(this->Matrices[1]);
    surfaces[1].Move(motions[1]);
    for (const relevo::IntersectingPair& pair : relevo::FindMeetingPairs(surfaces[0], surfaces[1]))
    {
      pairs.emplace(surfaces[0].GetCell(pair.Triangles[0]), surfaces[1].GetCell(pair.Triangles[1]));
    }
  }
  return pairs;
}

BenchmarkIntersectionWay::Pairs BenchmarkIntersectionWay::GetUnnamedPairs() const
{
  Pairs pairs;
  if (this->Policy != Lines && this->Policy != Splits)
  {
    return pairs;
  }
  vtkPolyData* lines = this->Filter->GetOutput();
  for (vtkIdType line = 0; line < lines->GetNumberOfLines(); ++line)
  {
    double ends[2][3];
    vtkPoints* points = lines->GetCell(line)->GetPoints();
    points->GetPoint(0, ends[0]);
    points->GetPoint(1, ends[1]);
    const std::vector<vtkIdType> seconds = FindCells(this->Second, ends);
    for (const vtkIdType first : FindCells(this->First, ends))
    {
      for (const vtkIdType second : seconds)
      {
        pairs.emplace(first, second);
      }
    }
  }
  return pairs;
}
