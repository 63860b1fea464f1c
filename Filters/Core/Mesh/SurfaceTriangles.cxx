// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/SurfaceTriangles.h"

#include "Points/MergedPoints.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <cmath>

namespace
{
// Calls f(size, points) for each cell.
template <typename Function>
void ForEachCell(vtkCellArray* cells, Function&& f)
{
  auto cell = vtk::TakeSmartPointer(cells->NewIterator());
  for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell())
  {
    vtkIdType size;
    const vtkIdType* points;
    cell->GetCurrentCell(size, points);
    f(size, points);
  }
}
}

namespace relevo
{
SurfaceTriangles::SurfaceTriangles(vtkPolyData* mesh, bool withUses)
  : Points(mesh->GetPoints())
  , MergedPoints(ComputeMergedPoints(mesh->GetPoints()))
  , NumberOfPoints(mesh->GetNumberOfPoints())
{
  for (std::size_t point = 0; point < this->MergedPoints.size(); ++point)
  {
    const auto id = static_cast<vtkIdType>(point);
    if (this->MergedPoints[point] != id)
    {
      this->CoincidentPoints.push_back(id);
    }
  }
  const vtkIdType firstPolygon = mesh->GetNumberOfVerts() + mesh->GetNumberOfLines();
  this->AddPolygons(mesh->GetPolys(), firstPolygon);
  this->AddStrips(mesh->GetStrips(), firstPolygon + mesh->GetNumberOfPolys());
  if (withUses)
  {
    this->FindUses();
  }
}

void SurfaceTriangles::FindUses()
{
  this->Starts.assign(this->NumberOfPoints + 1, 0);
  for (const Triangle& triangle : this->Triangles)
  {
    for (vtkIdType point : triangle)
    {
      ++this->Starts[point + 1];
    }
  }
  for (vtkIdType point = 0; point < this->NumberOfPoints; ++point)
  {
    this->Starts[point + 1] += this->Starts[point];
  }
  this->Uses.resize(3 * this->Triangles.size());
  std::vector<vtkIdType> next(this->Starts.begin(), this->Starts.end() - 1);
  for (std::size_t t = 0; t < this->Triangles.size(); ++t)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      this->Uses[next[this->Triangles[t][corner]]++] = 3 * static_cast<vtkIdType>(t) + corner;
    }
  }
}

void SurfaceTriangles::AddTriangle(vtkIdType cell, vtkIdType a, vtkIdType b, vtkIdType c)
{
  const Triangle points{ a, b, c };
  Triangle triangle = points;
  for (vtkIdType& point : triangle)
  {
    if (point < 0 || point >= this->NumberOfPoints)
    {
      return;
    }
    double x[3];
    this->GetPoint(point, x);
    if (!std::isfinite(x[0]) || !std::isfinite(x[1]) || !std::isfinite(x[2]))
    {
      return;
    }
    point = this->GetMergedPoint(point);
  }
  if (triangle[0] != triangle[1] && triangle[1] != triangle[2] && triangle[2] != triangle[0])
  {
    this->Triangles.push_back(triangle);
    if (!this->MergedPoints.empty())
    {
      this->PointTriangles.push_back(points);
    }
    this->Cells.push_back(cell);
  }
}

void SurfaceTriangles::AddPolygons(vtkCellArray* polygons, vtkIdType firstCell)
{
  this->Triangles.reserve(polygons->GetNumberOfCells());
  this->Cells.reserve(polygons->GetNumberOfCells());
  ForEachCell(polygons,
    [this, cell = firstCell](vtkIdType size, const vtkIdType* points) mutable
    {
      for (vtkIdType i = 1; i + 1 < size; ++i)
      {
        this->AddTriangle(cell, points[0], points[i], points[i + 1]);
      }
      ++cell;
    });
}

void SurfaceTriangles::AddStrips(vtkCellArray* strips, vtkIdType firstCell)
{
  ForEachCell(strips,
    [this, cell = firstCell](vtkIdType size, const vtkIdType* points) mutable
    {
      for (vtkIdType i = 0; i + 2 < size; ++i)
      {
        const vtkIdType odd = i % 2;
        this->AddTriangle(cell, points[i], points[i + 1 + odd], points[i + 2 - odd]);
      }
      ++cell;
    });
}
}
