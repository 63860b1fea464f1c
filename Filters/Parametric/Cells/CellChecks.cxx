// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/CellChecks.h"

#include "Cells/CellReader.h"
#include "Core/BezierDegree.h"
#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkGenericCell.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>

namespace relevo
{
namespace
{
enum class Fault : unsigned char
{
  None,
  Type,
  PointId,
  Nodes,
  Degree,
  Point,
  Weight,
  Number // of kinds
};

// What is known of the grid's points.
struct PointChecks
{
  std::vector<unsigned char> IsBadPoint;
  std::vector<unsigned char> IsBadWeight;
};

PointChecks CheckPoints(vtkUnstructuredGrid* grid)
{
  const vtkIdType number = grid->GetNumberOfPoints();
  vtkDataArray* weights = grid->GetPointData()->GetRationalWeights();
  PointChecks checks;
  checks.IsBadPoint.resize(number);
  checks.IsBadWeight.resize(weights ? number : 0);
  vtkSMPTools::For(0, number,
    [&](vtkIdType first, vtkIdType end)
    {
      for (vtkIdType i = first; i < end; ++i)
      {
        double x[3];
        grid->GetPoints()->GetPoint(i, x);
        checks.IsBadPoint[i] = !std::isfinite(x[0]) || !std::isfinite(x[1]) || !std::isfinite(x[2]);
        if (weights)
        {
          const double weight =
            i < weights->GetNumberOfTuples() ? weights->GetComponent(i, 0) : 0.0;
          checks.IsBadWeight[i] = !(weight > 0.0) || !std::isfinite(weight);
        }
      }
    });
  return checks;
}

// The first of a cell's points that is so. A polyhedron's faces have points of their own.
template <typename IsSo>
std::optional<vtkIdType> FindPoint(const CellReader& cell, const IsSo& isSo)
{
  for (vtkIdType node = 0; node < cell.GetNumberOfNodes(); ++node)
  {
    if (isSo(cell.GetNode(node)))
    {
      return cell.GetNode(node);
    }
  }
  const bool isPolyhedron = cell.GetKind().Shape == CellShape::Polyhedron;
  for (int face = 0; isPolyhedron && face < cell.GetNumberOfFaces(); ++face)
  {
    const std::vector<vtkIdType>& corners = cell.GetCorners(face);
    const auto found = std::find_if(corners.begin(), corners.end(), isSo);
    if (found != corners.end())
    {
      return *found;
    }
  }
  return std::nullopt;
}

std::optional<vtkIdType> FindPoint(const CellReader& cell, const std::vector<unsigned char>& marks)
{
  return FindPoint(cell, [&](vtkIdType point) { return marks[point] != 0; });
}

std::optional<vtkIdType> FindStrangePoint(const CellReader& cell, const PointChecks& points)
{
  const auto number = static_cast<vtkIdType>(points.IsBadPoint.size());
  return FindPoint(cell, [=](vtkIdType point) { return point < 0 || point >= number; });
}

bool IsOfAnyDegree(const CellKind& kind)
{
  return kind.Nodes == NodeKind::Lagrange || kind.Nodes == NodeKind::Bezier;
}

bool HasRightNumber(const CellReader& cell)
{
  const CellKind& kind = cell.GetKind();
  if (IsOfAnyDegree(kind))
  {
    const ivec3 degrees = cell.GetDegrees();
    return degrees != ivec3(0) && GetNumberOfNodes(kind.Shape, degrees) == cell.GetNumberOfNodes();
  }
  if (kind.NumberOfNodes)
  {
    return cell.GetNumberOfNodes() == kind.NumberOfNodes;
  }
  bool hasFaces = cell.GetNumberOfFaces() > 0;
  for (int face = 0; face < cell.GetNumberOfFaces(); ++face)
  {
    hasFaces = hasFaces && cell.GetCorners(face).size() >= 3;
  }
  return hasFaces;
}

// A wedge's first two degrees are one.
bool HasRightDegrees(const CellReader& cell)
{
  const ivec3 degrees = cell.GetDegrees();
  const CellShape shape = cell.GetKind().Shape;
  const int used = shape == CellShape::Quadrilateral ? 2 : 3;
  bool isRight = shape != CellShape::Wedge || degrees.x == degrees.y;
  for (int c = 0; c < used; ++c)
  {
    isRight = isRight && degrees[c] >= 1 && degrees[c] <= LargestDegree;
  }
  return isRight;
}

Fault FindFault(const CellReader& cell, const PointChecks& points)
{
  const CellKind& kind = cell.GetKind();
  if (kind.Shape == CellShape::Unknown)
  {
    return Fault::Type;
  }
  if (kind.Shape == CellShape::Thin)
  {
    return Fault::None;
  }
  if (FindStrangePoint(cell, points))
  {
    return Fault::PointId;
  }
  // No degree at all is a matter of the number of nodes.
  if (IsOfAnyDegree(kind) && !HasRightDegrees(cell) && cell.GetDegrees() != ivec3(0))
  {
    return Fault::Degree;
  }
  if (!HasRightNumber(cell))
  {
    return Fault::Nodes;
  }
  if (FindPoint(cell, points.IsBadPoint))
  {
    return Fault::Point;
  }
  const bool isRational = kind.Nodes == NodeKind::Bezier && !points.IsBadWeight.empty();
  return isRational && FindPoint(cell, points.IsBadWeight) ? Fault::Weight : Fault::None;
}

std::string GetTypeName(int type)
{
  const auto cell = vtk::TakeSmartPointer(vtkGenericCell::InstantiateCell(type));
  return (cell ? std::string(cell->GetClassName()) + ", type " : "type ") + std::to_string(type);
}

std::string DescribeFault(
  vtkUnstructuredGrid* grid, const PointChecks& points, vtkIdType id, Fault fault)
{
  CellReader cell(grid);
  cell.Read(id);
  const int type = grid->GetCellType(id);
  const ivec3 degrees = cell.GetDegrees();
  vtkDataArray* given = grid->GetCellData()->GetHigherOrderDegrees();
  std::ostringstream text;
  text << "Cell " << id << " (" << GetTypeName(type) << ") is left out: ";
  if (fault == Fault::Type)
  {
    text << "patches cannot be made of cells of this type";
  }
  else if (fault == Fault::PointId)
  {
    text << "it refers to point " << *FindStrangePoint(cell, points) << " of "
         << points.IsBadPoint.size();
  }
  else if (fault == Fault::Nodes && cell.GetKind().Shape == CellShape::Polyhedron)
  {
    text << "its list of faces is not whole, or has a face of less than 3 points";
  }
  else if (fault == Fault::Nodes)
  {
    text << "it has " << cell.GetNumberOfNodes() << " nodes, which does not fit its type";
    if (given && IsOfAnyDegree(cell.GetKind()))
    {
      text << " with the degrees " << degrees.x << ", " << degrees.y << ", " << degrees.z
           << " of \"HigherOrderDegrees\"";
    }
  }
  else if (fault == Fault::Degree)
  {
    text << "its degrees are " << degrees.x << ", " << degrees.y << ", " << degrees.z
         << (given ? " by \"HigherOrderDegrees\"" : "") << ", and may be 1 to " << LargestDegree
         << (cell.GetKind().Shape == CellShape::Wedge ? ", the first two the same" : "");
  }
  else if (fault == Fault::Point)
  {
    text << "point " << *FindPoint(cell, points.IsBadPoint) << " is not finite";
  }
  else
  {
    const vtkIdType point = *FindPoint(cell, points.IsBadWeight);
    vtkDataArray* weights = grid->GetPointData()->GetRationalWeights();
    text << "\"RationalWeights\" of point " << point;
    if (point < weights->GetNumberOfTuples())
    {
      text << " is " << weights->GetComponent(point, 0) << "; weights are more than 0, and finite";
    }
    else
    {
      text << " is missing";
    }
  }
  return text.str();
}

// Hidden cells are as if they were not there.
bool IsHidden(vtkUnsignedCharArray* ghosts, vtkIdType cell)
{
  return ghosts && cell < ghosts->GetNumberOfTuples() &&
    (ghosts->GetValue(cell) & vtkDataSetAttributes::HIDDENCELL) != 0;
}
}

CellChecks CheckCells(vtkUnstructuredGrid* grid)
{
  const vtkIdType number = grid->GetNumberOfCells();
  const PointChecks points = CheckPoints(grid);
  vtkUnsignedCharArray* ghosts = grid->GetCellGhostArray();
  CellChecks checks;
  checks.Uses.resize(number, CellUse::None);
  std::vector<Fault> faults(number, Fault::None);
  vtkSMPTools::For(0, number,
    [&](vtkIdType first, vtkIdType end)
    {
      CellReader cell(grid);
      for (vtkIdType i = first; i < end; ++i)
      {
        cell.Read(i);
        faults[i] = IsHidden(ghosts, i) ? Fault::None : FindFault(cell, points);
        if (faults[i] == Fault::None && !IsHidden(ghosts, i))
        {
          checks.Uses[i] = cell.GetKind().IsSolid() ? CellUse::Solid
            : cell.GetKind().IsSurface()            ? CellUse::Surface
                                                    : CellUse::None;
        }
      }
    });
  for (int k = 1; k < static_cast<int>(Fault::Number); ++k)
  {
    const Fault fault = static_cast<Fault>(k);
    const auto first = std::find(faults.begin(), faults.end(), fault);
    if (first != faults.end())
    {
      const auto others = std::count(first + 1, faults.end(), fault);
      checks.Faults.push_back(DescribeFault(grid, points, first - faults.begin(), fault) +
        (others ? ". So it is with " + std::to_string(others) + " more cells." : "."));
    }
  }
  return checks;
}
}
