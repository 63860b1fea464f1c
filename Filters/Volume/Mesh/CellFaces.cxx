// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/CellFaces.h"

#include "Cells/CellChecks.h"
#include "Mathematics/RefinementMathematics.h"
#include "Mesh/CellFetcher.h"
#include "Mesh/FaceTable.h"
#include "Points/MergedPoints.h"
#include "vtkCell.h"
#include "vtkCellType.h"
#include "vtkDataSet.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"

#include <algorithm>
#include <initializer_list>

namespace relevo
{
namespace
{
using Face = std::array<int, 4>;
// Returns corners of a polygon that are far apart, because others may be collinear.
Face FindShape(vtkCell* polygon)
{
  std::vector<dvec3> points(polygon->GetNumberOfPoints());
  for (size_t i = 0; i < points.size(); ++i)
  {
    polygon->GetPoints()->GetPoint(static_cast<vtkIdType>(i), &points[i].x);
  }
  const auto findFarthest = [&](size_t begin, size_t end, auto getDistance)
  {
    size_t farthest = begin;
    for (size_t i = begin; i < end; ++i)
    {
      farthest = getDistance(points[i]) > getDistance(points[farthest]) ? i : farthest;
    }
    return farthest;
  };
  const size_t opposite =
    findFarthest(1, points.size(), [&](const dvec3& point) { return distance(point, points[0]); });
  const auto getHeight = [&](const dvec3& point)
  { return length(cross(point - points[0], points[opposite] - points[0])); };
  const size_t second = findFarthest(0, opposite, getHeight);
  const size_t last = findFarthest(opposite, points.size(), getHeight);
  Face face;
  int corner = 0;
  for (size_t i : { size_t(0), second, opposite, last })
  {
    face[corner++] = static_cast<int>(polygon->GetPointId(static_cast<int>(i)));
  }
  return face;
}
}

CellFaces::CellFaces(std::vector<vtkIdType> mergedPoints)
  : MergedPoints(std::move(mergedPoints))
{
}

int CellFaces::Merge(vtkIdType point)
{
  return static_cast<int>(this->MergedPoints.empty() ? point : this->MergedPoints[point]);
}

void CellFaces::Reserve(size_t numberOfCells)
{
  this->Firsts.reserve(numberOfCells + 1);
  this->Faces.reserve(4 * numberOfCells);
}

bool CellFaces::Add(int type, const vtkIdType* points)
{
  const FaceTable table = FindFaceTable(type);
  for (int i = 0; i < table.NumberOfFaces; ++i)
  {
    Face face = table.Faces[i];
    for (int& corner : face)
    {
      corner = corner < 0 ? -1 : this->Merge(points[corner]);
    }
    this->Faces.push_back(face);
  }
  if (table.NumberOfFaces > 0)
  {
    this->Firsts.push_back(this->Faces.size());
  }
  return table.NumberOfFaces > 0;
}

void CellFaces::Add(vtkCell* cell)
{
  for (int i = 0; i < cell->GetNumberOfFaces(); ++i)
  {
    vtkCell* side = cell->GetFace(i);
    // Corners precede the points of edges, and there are as many corners as edges.
    const int size = side->GetNumberOfEdges();
    std::vector<int> corners;
    for (int corner = 0; corner < size; ++corner)
    {
      corners.push_back(this->Merge(side->GetPointId(corner)));
    }
    if (size > 4)
    {
      this->Polygons[this->Faces.size()] = FindShape(side);
      std::sort(corners.begin(), corners.end());
    }
    if (size > 2)
    {
      this->Faces.push_back({ { corners[0], corners[1], corners[2], size > 3 ? corners[3] : -1 } });
    }
  }
  this->Firsts.push_back(this->Faces.size());
}

CellFaces ReadCellFaces(
  vtkDataSet* mesh, std::vector<vtkIdType>& cells, std::vector<std::string>& errors)
{
  CellDemands demands;
  demands.TakesAllTypes = true;
  demands.TakesInfinitePoints = true;
  demands.TakesHiddenCells = true;
  const CellChecks checks = CheckCells(mesh, demands);
  errors = checks.Errors;
  auto* pointSet = vtkPointSet::SafeDownCast(mesh);
  CellFaces faces(pointSet ? ComputeMergedPoints(pointSet->GetPoints()) : std::vector<vtkIdType>());
  faces.Reserve(mesh->GetNumberOfCells());
  cells.clear();
  cells.reserve(mesh->GetNumberOfCells());
  vtkNew<vtkIdList> points;
  CellFetcher fetcher(mesh);
  for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
  {
    if (checks.Uses[i] != CellUse::Solid)
    {
      continue;
    }
    const int type = mesh->GetCellType(i);
    if (FindFaceTable(type).NumberOfFaces > 0)
    {
      mesh->GetCellPoints(i, points);
      faces.Add(type, points->GetPointer(0));
      cells.push_back(i);
      continue;
    }
    vtkGenericCell* cell = fetcher.Fetch(i);
    if (cell->GetCellDimension() == 3)
    {
      faces.Add(cell);
      cells.push_back(i);
    }
  }
  return faces;
}
}
