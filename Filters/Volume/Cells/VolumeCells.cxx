// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/VolumeCells.h"

#include "Cells/CellChecks.h"
#include "Cells/CellSplitter.h"
#include "Mathematics/FiniteBox.h"
#include "Mesh/CellFetcher.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace relevo
{
namespace
{
// Relative to a cube with the longest distance between corners. Smaller cells have no volume.
constexpr double MinimumVolume = 1e-12;

bool IsFinite(const Scalars& scalars)
{
  return std::all_of(
    scalars.begin(), scalars.end(), [](double value) { return std::isfinite(value); });
}

bool IsFinite(const dvec3& point)
{
  return std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.z);
}

// The cells that are hidden or belong to another piece.
class LeftOutCells
{
public:
  explicit LeftOutCells(vtkDataSet* mesh)
    : Cells(mesh->GetCellGhostArray())
    , Points(mesh->GetPointGhostArray())
  {
  }
  bool IsGhost(vtkIdType cell) const
  {
    return this->HasFlag(cell, vtkDataSetAttributes::DUPLICATECELL);
  }
  bool IsHidden(vtkIdType cell, vtkIdList* points) const
  {
    if (this->HasFlag(cell, vtkDataSetAttributes::HIDDENCELL | vtkDataSetAttributes::REFINEDCELL))
    {
      return true;
    }
    for (vtkIdType i = 0; this->Points && i < points->GetNumberOfIds(); ++i)
    {
      const vtkIdType point = points->GetId(i);
      if (point < this->Points->GetNumberOfTuples() &&
        (this->Points->GetValue(point) & vtkDataSetAttributes::HIDDENPOINT))
      {
        return true;
      }
    }
    return false;
  }

private:
  bool HasFlag(vtkIdType cell, int flags) const
  {
    return this->Cells && cell < this->Cells->GetNumberOfTuples() &&
      (this->Cells->GetValue(cell) & flags) != 0;
  }

  vtkUnsignedCharArray* Cells;
  vtkUnsignedCharArray* Points;
};
}

std::vector<std::string> VolumeCells::Add(
  vtkDataSet* mesh, vtkDataArray* array, bool isOfCells, const ScalarChoice& choice)
{
  const vtkIdType firstPoint = static_cast<vtkIdType>(this->Points.size());
  const vtkIdType firstCell = static_cast<vtkIdType>(this->CellScalars.size());
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    dvec3 point;
    mesh->GetPoint(i, &point.x);
    this->Points.push_back(point);
  }
  AddScalars(array, choice, isOfCells ? this->CellScalars : this->PointScalars);
  // Both arrays must have the same length for the following data sets.
  (isOfCells ? this->PointScalars : this->CellScalars)
    .resize(isOfCells ? this->Points.size() : firstCell);

  CellDemands demands;
  demands.TakesAllTypes = true;
  demands.TakesInfinitePoints = true;
  const CellChecks checks = CheckCells(mesh, demands);
  const LeftOutCells leftOut(mesh);
  CellFetcher cells(mesh);
  CellSplitter splitter;
  std::vector<vtkIdType> ids;
  std::vector<vtkIdType> corners;
  for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
  {
    if (checks.Uses[i] != CellUse::Solid)
    {
      continue;
    }
    vtkGenericCell* cell = cells.Fetch(i);
    vtkIdList* points = cell->GetPointIds();
    const bool isGhost = leftOut.IsGhost(i);
    if (cell->GetCellDimension() != 3 || leftOut.IsHidden(i, points) || (isGhost && isOfCells))
    {
      continue;
    }
    if (!this->AreFinite(points, firstPoint))
    {
      this->NumberOfSolidCells += isGhost ? 0 : 1;
      this->NumberOfBadCells += isGhost ? 0 : 1;
      continue;
    }
    const int type = cell->GetCellType();
    const CellShape* shape = this->SplitsAll ? nullptr : FindCellShape(type);
    if (shape || type == VTK_TETRA)
    {
      ids.assign(points->begin(), points->end());
    }
    else
    {
      ids = splitter.Split(cell, &this->Points[firstPoint]);
    }
    const size_t size = shape ? static_cast<size_t>(shape->NumberOfCorners) : 4;
    bool isGood = false;
    const size_t before = this->Cells.size();
    for (size_t first = 0; first + size <= ids.size(); first += size)
    {
      corners.clear();
      for (size_t corner = 0; corner < size; ++corner)
      {
        corners.push_back(
          firstPoint + ids[first + (shape ? GetCorner(type, static_cast<int>(corner)) : corner)]);
      }
      isGood |= this->AddCell(
        shape, corners, isOfCells ? firstCell + i : -1, isGhost ? this->Ghosts : this->Cells);
    }
    if (isGhost)
    {
      continue;
    }
    this->NumberOfSolidCells++;
    this->NumberOfBadCells += isGood ? 0 : 1;
    this->NumberOfDrawnCells += this->Cells.size() > before ? 1 : 0;
  }
  return checks.Errors;
}

// VTK's functions that split cells do not terminate if coordinates are NaN.
bool VolumeCells::AreFinite(vtkIdList* points, vtkIdType firstPoint) const
{
  return std::all_of(points->begin(), points->end(),
    [&](vtkIdType point) { return IsFinite(this->Points[firstPoint + point]); });
}

int VolumeCells::GetNumberOfCorners(const Cell& cell) const
{
  return cell.Shape ? cell.Shape->NumberOfCorners : 4;
}

vtkIdType VolumeCells::GetCornerId(const Cell& cell, int i) const
{
  return this->Corners[cell.FirstCorner + i];
}

void VolumeCells::GetRange(int component, double& low, double& high) const
{
  low = std::numeric_limits<double>::max();
  high = -low;
  const auto add = [&](const Scalars& scalars)
  {
    low = std::min(low, scalars[component]);
    high = std::max(high, scalars[component]);
  };
  for (const Cell& cell : this->Cells)
  {
    if (cell.Scalars >= 0)
    {
      add(this->CellScalars[cell.Scalars]);
    }
    for (int i = 0; i < this->GetNumberOfCorners(cell) && cell.Scalars < 0; ++i)
    {
      add(this->PointScalars[this->GetCornerId(cell, i)]);
    }
  }
}

TetrahedronCorners VolumeCells::GetTetrahedron(const Cell& cell) const
{
  TetrahedronCorners corners;
  for (int i = 0; i < 4; ++i)
  {
    corners[i] = this->Points[this->GetCornerId(cell, i)];
  }
  return corners;
}

CurvedCell VolumeCells::GetCurved(const Cell& cell) const
{
  CurvedCell curved(*cell.Shape);
  for (int i = 0; i < cell.Shape->NumberOfCorners; ++i)
  {
    curved.SetCorner(i, this->Points[this->GetCornerId(cell, i)]);
  }
  return curved;
}

// Returns whether the cell has a volume. Cells with scalars that are not finite are transparent and
// are not stored.
bool VolumeCells::AddCell(const CellShape* shape, const std::vector<vtkIdType>& corners,
  vtkIdType scalars, std::vector<Cell>& all)
{
  const Cell cell = { shape, this->Corners.size(), scalars };
  this->Corners.insert(this->Corners.end(), corners.begin(), corners.end());
  const bool hasVolume = this->HasVolume(cell);
  if (hasVolume && this->HasScalars(cell))
  {
    all.push_back(cell);
  }
  else
  {
    this->Corners.resize(cell.FirstCorner);
  }
  return hasVolume;
}

bool VolumeCells::HasVolume(const Cell& cell) const
{
  double longest = 0.0;
  for (int i = 0; i < this->GetNumberOfCorners(cell); ++i)
  {
    const dvec3& point = this->Points[this->GetCornerId(cell, i)];
    if (!IsFinite(point))
    {
      return false;
    }
    for (int j = 0; j < i; ++j)
    {
      longest = std::max(longest, distance(point, this->Points[this->GetCornerId(cell, j)]));
    }
  }
  const double volume = cell.Shape ? this->GetCurved(cell).ComputeVolume()
                                   : ComputeSixfoldVolume(this->GetTetrahedron(cell));
  return volume > MinimumVolume * longest * longest * longest;
}

bool VolumeCells::HasScalars(const Cell& cell) const
{
  if (cell.Scalars >= 0)
  {
    return IsFinite(this->CellScalars[cell.Scalars]);
  }
  for (int i = 0; i < this->GetNumberOfCorners(cell); ++i)
  {
    if (!IsFinite(this->PointScalars[this->GetCornerId(cell, i)]))
    {
      return false;
    }
  }
  return true;
}

// Uses differences, so that the gradient of constant scalars is exactly 0.
Gradients VolumeCells::ComputeGradients(const Cell& cell, const CornerSlopes& slopes) const
{
  Gradients gradients = {};
  const Scalars& first = this->PointScalars[this->GetCornerId(cell, 0)];
  for (int i = 1; i < this->GetNumberOfCorners(cell); ++i)
  {
    const Scalars& scalars = this->PointScalars[this->GetCornerId(cell, i)];
    for (size_t c = 0; c < scalars.size(); ++c)
    {
      gradients[c] += (scalars[c] - first[c]) * slopes[i];
    }
  }
  return gradients;
}

void VolumeCells::MoveToOrigin()
{
  FiniteBox box;
  for (const Cell& cell : this->Cells)
  {
    for (int i = 0; i < this->GetNumberOfCorners(cell); ++i)
    {
      box.Add(&this->Points[this->GetCornerId(cell, i)].x);
    }
  }
  this->Middle = dvec3(box.GetMiddle(0), box.GetMiddle(1), box.GetMiddle(2));
  this->Diagonal = length(dvec3(box.GetSide(0), box.GetSide(1), box.GetSide(2)));
  for (dvec3& point : this->Points)
  {
    point -= this->Middle;
  }
}
}
