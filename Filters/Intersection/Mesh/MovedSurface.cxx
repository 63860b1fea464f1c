// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/MovedSurface.h"

#include "Arrays/GhostCells.h"
#include "Changes/LatestTime.h"
#include "Exact/ExactPredicates.h"
#include "Mesh/SurfaceTriangles.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"

#include <atomic>
#include <cmath>
#include <utility>

namespace relevo
{
namespace
{
// Differences and sums of such coordinates are finite.
constexpr double LargestCoordinate = 1e300;

bool IsInRange(const double x[3])
{
  return std::abs(x[0]) <= LargestCoordinate && std::abs(x[1]) <= LargestCoordinate &&
    std::abs(x[2]) <= LargestCoordinate;
}

vtkAbstractArray* GetGhosts(vtkPolyData* mesh)
{
  return mesh->GetCellData()->GetAbstractArray(vtkDataSetAttributes::GhostArrayName());
}

// The sizes are included because inserting cells does not modify the time of a vtkCellArray.
std::array<vtkMTimeType, 4> GetState(vtkPolyData* mesh)
{
  vtkPoints* points = mesh->GetPoints();
  const vtkIdType sizes[3] = { mesh->GetNumberOfPoints(),
    mesh->GetPolys()->GetNumberOfConnectivityIds(),
    mesh->GetStrips()->GetNumberOfConnectivityIds() };
  return { GetLatestTime(0,
             { points, points ? points->GetData() : nullptr, mesh->GetPolys(), mesh->GetStrips(),
               GetGhosts(mesh) }),
    static_cast<vtkMTimeType>(sizes[0]), static_cast<vtkMTimeType>(sizes[1]),
    static_cast<vtkMTimeType>(sizes[2]) };
}

// Returns an error of the cells, or "".
std::string CheckCells(vtkPolyData* mesh, vtkCellArray* cells, vtkIdType first)
{
  auto cell = vtk::TakeSmartPointer(cells->NewIterator());
  for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell())
  {
    vtkIdType size;
    const vtkIdType* points;
    cell->GetCurrentCell(size, points);
    for (vtkIdType i = 0; i < size; ++i)
    {
      if (points[i] < 0 || points[i] >= mesh->GetNumberOfPoints())
      {
        return "has no point " + std::to_string(points[i]) + ", which cell " +
          std::to_string(first + cell->GetCurrentCellId()) + " refers to";
      }
      double x[3];
      mesh->GetPoint(points[i], x);
      if (!IsInRange(x))
      {
        return "has a point " + std::to_string(points[i]) + " that is not finite or exceeds 1e300";
      }
    }
  }
  return {};
}

// Counts the triangles of polygons and strips, including those with two coincident corners.
vtkIdType CountTriangles(vtkCellArray* cells)
{
  vtkIdType number = 0;
  for (vtkIdType i = 0; i < cells->GetNumberOfCells(); ++i)
  {
    number += std::max<vtkIdType>(cells->GetCellSize(i) - 2, 0);
  }
  return number;
}
}

MovedSurface::MovedSurface() = default;
MovedSurface::~MovedSurface() = default;

bool MovedSurface::IsOf(vtkPolyData* mesh) const
{
  return this->Triangles && this->Points == mesh->GetPoints() &&
    this->Polygons == mesh->GetPolys() && this->Strips == mesh->GetStrips() &&
    this->Ghosts == GetGhosts(mesh) && this->State == GetState(mesh);
}

void MovedSurface::Clear()
{
  this->Triangles.reset();
  this->IsMoved = false;
  this->Closed = -1;
}

std::string CheckSurface(vtkPolyData* mesh)
{
  if (mesh->GetNumberOfPolys() + mesh->GetNumberOfStrips() == 0)
  {
    return "has no polygons and no strips";
  }
  const vtkIdType first = mesh->GetNumberOfVerts() + mesh->GetNumberOfLines();
  const std::string error = CheckCells(mesh, mesh->GetPolys(), first);
  return error.empty() ? CheckCells(mesh, mesh->GetStrips(), first + mesh->GetNumberOfPolys())
                       : error;
}

std::string MovedSurface::Take(vtkPolyData* mesh, std::vector<vtkIdType> cells)
{
  this->Clear();
  std::string error = CheckSurface(mesh);
  if (!error.empty())
  {
    return error;
  }
  this->Points = mesh->GetPoints();
  this->Polygons = mesh->GetPolys();
  this->Strips = mesh->GetStrips();
  this->Ghosts = GetGhosts(mesh);
  this->State = GetState(mesh);
  this->Cells = std::move(cells);
  vtkNew<vtkPolyData> own;
  own->ShallowCopy(mesh);
  EmptyGhostFaces(mesh, own);
  this->Triangles = std::make_unique<SurfaceTriangles>(own);
  this->NumberOfCollapsedTriangles =
    CountTriangles(own->GetPolys()) + CountTriangles(own->GetStrips());
  this->NumberOfCollapsedTriangles -= this->GetNumberOfTriangles();
  this->AreUsed.assign(this->GetNumberOfPoints(), 0);
  for (const Triangle& triangle : this->Triangles->GetTriangles())
  {
    for (vtkIdType corner : triangle)
    {
      this->AreUsed[corner] = 1;
    }
  }
  return {};
}

bool MovedSurface::MovePoints(const Motion& motion)
{
  this->Moved.resize(3 * this->GetNumberOfPoints());
  std::atomic<bool> isInRange(true);
  vtkSMPTools::For(0, this->GetNumberOfPoints(),
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType i = first; i < last; ++i)
      {
        double x[3];
        double* moved = &this->Moved[3 * i];
        this->Triangles->GetPoint(i, x);
        motion.Move(x, moved);
        if (this->AreUsed[i] && !IsInRange(moved))
        {
          isInRange = false;
        }
      }
    });
  return isInRange;
}

std::vector<DoubleBox> MovedSurface::MeasureTriangles() const
{
  std::vector<DoubleBox> boxes(this->GetNumberOfTriangles());
  vtkSMPTools::For(0, this->GetNumberOfTriangles(),
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType t = first; t < last; ++t)
      {
        for (const double* point : this->GetPoints(t))
        {
          boxes[t].Add(point);
        }
      }
    });
  return boxes;
}

std::string MovedSurface::Move(const Motion& motion)
{
  if (this->IsMoved && motion == this->Current)
  {
    return {};
  }
  const bool isFirst = !this->IsMoved;
  this->IsMoved = false; // in case of an error
  if (!this->MovePoints(motion))
  {
    this->Clear();
    return "has a matrix that moves points beyond 1e300";
  }
  const vtkIdType number = this->GetNumberOfTriangles();
  if (isFirst)
  {
    this->Tree.Build(this->MeasureTriangles());
  }
  else
  {
    this->Tree.Fit(this->MeasureTriangles());
  }
  this->Areas.resize(number);
  std::atomic<vtkIdType> flat(this->NumberOfCollapsedTriangles);
  vtkSMPTools::For(0, number,
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType t = first; t < last; ++t)
      {
        const auto p = this->GetPoints(t);
        this->Areas[t] = FindAxis(p[0], p[1], p[2]) >= 0;
        if (this->Areas[t] == 0)
        {
          ++flat;
        }
      }
    });
  this->NumberOfFlatTriangles = flat;
  this->Current = motion;
  this->IsMoved = true;
  return {};
}

vtkIdType MovedSurface::GetNumberOfTriangles() const
{
  return static_cast<vtkIdType>(this->Triangles->GetTriangles().size());
}

const MovedSurface::Triangle& MovedSurface::GetCorners(vtkIdType triangle) const
{
  return this->Triangles->GetTriangles()[triangle];
}

vtkIdType MovedSurface::GetCell(vtkIdType triangle) const
{
  const vtkIdType cell = this->Triangles->GetCell(triangle);
  return this->Cells.empty() ? cell : this->Cells[cell];
}

vtkIdType MovedSurface::GetNumberOfPoints() const
{
  return this->Triangles->GetNumberOfPoints();
}

std::array<const double*, 3> MovedSurface::GetPoints(vtkIdType triangle) const
{
  const Triangle& corners = this->GetCorners(triangle);
  return { this->GetPoint(corners[0]), this->GetPoint(corners[1]), this->GetPoint(corners[2]) };
}

bool MovedSurface::IsClosed() const
{
  if (this->Closed < 0)
  {
    std::vector<std::pair<vtkIdType, vtkIdType>> sides;
    sides.reserve(3 * this->GetNumberOfTriangles());
    for (vtkIdType t = 0; t < this->GetNumberOfTriangles(); ++t)
    {
      const Triangle& corners = this->GetCorners(t);
      for (int i = 0; i < 3; ++i)
      {
        sides.push_back(std::minmax(corners[i], corners[(i + 1) % 3]));
      }
    }
    vtkSMPTools::Sort(sides.begin(), sides.end());
    bool isClosed = sides.size() % 2 == 0;
    for (std::size_t i = 0; isClosed && i < sides.size(); i += 2)
    {
      isClosed = sides[i] == sides[i + 1] && (i == 0 || sides[i] != sides[i - 1]);
    }
    this->Closed = isClosed;
  }
  return this->Closed == 1;
}
}
