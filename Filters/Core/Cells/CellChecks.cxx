// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/CellChecks.h"

#include "Cells/CellReader.h"
#include "Mathematics/BezierDegree.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkRectilinearGrid.h"
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
enum class CellError : unsigned char
{
  None,
  List,
  Type,
  PointId,
  Nodes,
  Faces,
  OwnPoint,
  Degree,
  Point,
  Weight,
  Number // number of kinds
};

// The results of checking the points of the grid.
struct PointChecks
{
  std::vector<unsigned char> IsBadPoint;
  std::vector<unsigned char> IsBadWeight;
};

PointChecks CheckPoints(vtkUnstructuredGrid* grid)
{
  const vtkIdType number = grid->GetNumberOfPoints();
  vtkDataArray* weights = grid->GetPointData()->GetRationalWeights();
  const vtkIdType numberOfWeights =
    weights && weights->GetNumberOfComponents() == 1 ? weights->GetNumberOfTuples() : 0;
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
          const double weight = i < numberOfWeights ? weights->GetComponent(i, 0) : 0.0;
          checks.IsBadWeight[i] = !(weight > 0.0) || !std::isfinite(weight);
        }
      }
    });
  return checks;
}

bool IsPolyhedron(const CellReader& cell)
{
  return cell.GetKind().Shape == CellTopology::Polyhedron;
}

// Finds the first point of a cell for which the predicate is true. Faces of a polyhedron can have
// additional points.
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
  for (int face = 0; IsPolyhedron(cell) && face < cell.GetNumberOfFaces(); ++face)
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

// Finds a point of a polyhedron's face that the cell does not list.
std::optional<vtkIdType> FindUnlistedPoint(const CellReader& cell)
{
  std::vector<vtkIdType> own;
  for (vtkIdType node = 0; node < cell.GetNumberOfNodes(); ++node)
  {
    own.push_back(cell.GetNode(node));
  }
  std::sort(own.begin(), own.end());
  return FindPoint(
    cell, [&](vtkIdType point) { return !std::binary_search(own.begin(), own.end(), point); });
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
    return GetNumberOfNodes(kind.Shape, cell.GetDegrees()) == cell.GetNumberOfNodes();
  }
  return kind.NumberOfNodes ? cell.GetNumberOfNodes() == kind.NumberOfNodes
                            : cell.GetNumberOfNodes() >= kind.MinimumNodes;
}

bool HasRightFaces(const CellReader& cell)
{
  bool areRight = cell.GetNumberOfFaces() > 0;
  for (int face = 0; face < cell.GetNumberOfFaces(); ++face)
  {
    areRight = areRight && cell.GetCorners(face).size() >= 3;
  }
  return areRight;
}

// The number of degrees of cells of a shape.
int GetNumberOfDegrees(CellTopology shape)
{
  return shape == CellTopology::Triangle || shape == CellTopology::Quadrilateral ? 2 : 3;
}

// The first two degrees of a wedge must be equal. Simplices have one degree, which the grid may
// omit.
bool HasRightDegrees(const CellReader& cell)
{
  const CellTopology shape = cell.GetKind().Shape;
  if (cell.LacksDegrees())
  {
    return false;
  }
  const ivec3 degrees = cell.GetDegrees();
  bool isRight = shape != CellTopology::Wedge || degrees.x == degrees.y;
  for (int c = 0; c < GetNumberOfDegrees(shape); ++c)
  {
    const double given = cell.GetGivenDegree(c);
    isRight = isRight && degrees[c] >= 1 && degrees[c] <= LargestDegree &&
      (given == degrees[c] || (IsSimplex(shape) && given == 0.0));
  }
  return isRight;
}

// Lagrange cells with nodes at the centres of faces are quadratic.
bool IsQuadraticLagrange(int type, const CellKind& kind)
{
  return kind.Nodes == NodeKind::Quadratic && type >= VTK_LAGRANGE_CURVE;
}

bool IsOfSecondDegree(const CellReader& cell)
{
  const CellTopology shape = cell.GetKind().Shape;
  bool isRight = !cell.LacksDegrees();
  for (int c = 0; isRight && c < GetNumberOfDegrees(shape); ++c)
  {
    const double given = cell.GetGivenDegree(c);
    isRight = given == 2.0 || (given == 0.0 && shape != CellTopology::Wedge);
  }
  return isRight;
}

// Checks the cells of a grid. Each thread has a separate reader.
class GridChecks
{
public:
  GridChecks(vtkUnstructuredGrid* grid, const CellDemands& demands)
    : Grid(grid)
    , Demands(demands)
    , Ghosts(demands.TakesHiddenCells ? nullptr : grid->GetCellGhostArray())
    , Points(CheckPoints(grid))
    , HasDegrees(grid->GetCellData()->GetHigherOrderDegrees() != nullptr)
  {
  }

  // Hidden cells are ignored.
  bool IsHidden(vtkIdType cell) const
  {
    return this->Ghosts && cell < this->Ghosts->GetNumberOfTuples() &&
      (this->Ghosts->GetValue(cell) & vtkDataSetAttributes::HIDDENCELL) != 0;
  }

  // Reads the cell.
  CellError Find(CellReader& cell, vtkIdType id) const
  {
    if (!cell.ReadNodes(id))
    {
      return CellError::List;
    }
    const CellTopology shape = cell.GetKind().Shape;
    const bool hasNoFaces =
      shape == CellTopology::QuadraticPolygon || shape == CellTopology::PointSet;
    if (shape == CellTopology::Unknown || (hasNoFaces && !this->Demands.TakesAllTypes))
    {
      return CellError::Type;
    }
    if (shape == CellTopology::Empty)
    {
      return CellError::None;
    }
    if (IsPolyhedron(cell))
    {
      cell.Read(id);
    }
    if (FindStrangePoint(cell, this->Points))
    {
      return CellError::PointId;
    }
    const CellError error = this->FindShapeError(cell);
    const bool isThin = !cell.GetKind().IsSolid() && !cell.GetKind().IsSurface();
    return error != CellError::None || isThin ? error : this->FindValueError(cell);
  }

  std::string Describe(vtkIdType id, CellError error) const;

private:
  CellError FindShapeError(const CellReader& cell) const
  {
    const CellKind& kind = cell.GetKind();
    // No degree has this number of nodes.
    const bool hasNoDegree =
      cell.GetDegrees() == ivec3(0) && (IsSimplex(kind.Shape) || !this->HasDegrees);
    const bool hasWrongDegrees = IsOfAnyDegree(kind) && !hasNoDegree && !HasRightDegrees(cell);
    if (hasWrongDegrees ||
      (this->HasDegrees && IsQuadraticLagrange(this->Grid->GetCellType(cell.GetCell()), kind) &&
        !IsOfSecondDegree(cell)))
    {
      return CellError::Degree;
    }
    if (!HasRightNumber(cell))
    {
      return CellError::Nodes;
    }
    if (!IsPolyhedron(cell))
    {
      return CellError::None;
    }
    if (!HasRightFaces(cell))
    {
      return CellError::Faces;
    }
    return FindUnlistedPoint(cell) ? CellError::OwnPoint : CellError::None;
  }

  CellError FindValueError(const CellReader& cell) const
  {
    if (!this->Demands.TakesInfinitePoints && FindPoint(cell, this->Points.IsBadPoint))
    {
      return CellError::Point;
    }
    const bool isRational =
      cell.GetKind().Nodes == NodeKind::Bezier && !this->Points.IsBadWeight.empty();
    return isRational && FindPoint(cell, this->Points.IsBadWeight) ? CellError::Weight
                                                                   : CellError::None;
  }

  std::string DescribeNodes(const CellReader& cell) const;
  std::string DescribeDegrees(const CellReader& cell) const;
  std::string DescribeWeight(vtkIdType point) const;

  vtkUnstructuredGrid* Grid;
  CellDemands Demands;
  vtkUnsignedCharArray* Ghosts;
  PointChecks Points;
  bool HasDegrees;
};

std::string GetTypeName(int type)
{
  const auto cell = vtk::TakeSmartPointer(vtkGenericCell::InstantiateCell(type));
  return (cell ? std::string(cell->GetClassName()) + ", type " : "type ") + std::to_string(type);
}

std::string GridChecks::DescribeNodes(const CellReader& cell) const
{
  std::ostringstream text;
  text << "a cell of this type cannot have " << cell.GetNumberOfNodes() << " nodes";
  const ivec3 degrees = cell.GetDegrees();
  if (this->HasDegrees && IsOfAnyDegree(cell.GetKind()) && !IsSimplex(cell.GetKind().Shape))
  {
    text << " with the degrees " << degrees.x << ", " << degrees.y << ", " << degrees.z
         << " of \"HigherOrderDegrees\"";
  }
  return text.str();
}

std::string GridChecks::DescribeDegrees(const CellReader& cell) const
{
  std::ostringstream text;
  if (cell.LacksDegrees())
  {
    text << "\"HigherOrderDegrees\" has no tuple of 3 numbers for it";
    return text.str();
  }
  text << "its degrees are " << cell.GetGivenDegree(0) << ", " << cell.GetGivenDegree(1) << ", "
       << cell.GetGivenDegree(2) << (this->HasDegrees ? " in \"HigherOrderDegrees\"" : "");
  const CellTopology shape = cell.GetKind().Shape;
  if (cell.GetKind().Nodes == NodeKind::Quadratic)
  {
    text << ", but its " << cell.GetNumberOfNodes() << " nodes need degree 2";
  }
  else if (IsSimplex(shape) && cell.GetDegrees().x <= LargestDegree)
  {
    text << ", but its " << cell.GetNumberOfNodes() << " nodes need degree " << cell.GetDegrees().x;
  }
  else
  {
    text << ", but degrees must be whole numbers from 1 to " << LargestDegree
         << (shape == CellTopology::Wedge ? ", and the first two must be equal" : "");
  }
  return text.str();
}

std::string GridChecks::DescribeWeight(vtkIdType point) const
{
  vtkDataArray* weights = this->Grid->GetPointData()->GetRationalWeights();
  std::ostringstream text;
  text << "point " << point << " has ";
  if (weights->GetNumberOfComponents() == 1 && point < weights->GetNumberOfTuples())
  {
    text << "the weight " << weights->GetComponent(point, 0)
         << " in \"RationalWeights\"; weights must be positive and finite";
  }
  else
  {
    text << "no weight in \"RationalWeights\"";
  }
  return text.str();
}

std::string GridChecks::Describe(vtkIdType id, CellError error) const
{
  std::ostringstream text;
  if (error == CellError::List)
  {
    text << "Cell " << id
         << " is left out: the grid's arrays of cell types, offsets and point ids are too short "
            "for it, or its offsets decrease";
    return text.str();
  }
  CellReader cell(this->Grid);
  cell.Read(id);
  text << "Cell " << id << " (" << GetTypeName(this->Grid->GetCellType(id)) << ") is left out: ";
  switch (error)
  {
    case CellError::Type:
      text << "cells of this type are not supported";
      break;
    case CellError::PointId:
      text << "it refers to point " << *FindStrangePoint(cell, this->Points) << ", but there are "
           << this->Points.IsBadPoint.size() << " points";
      break;
    case CellError::Nodes:
      text << this->DescribeNodes(cell);
      break;
    case CellError::Faces:
      text << "its list of faces is incomplete, or has a face with fewer than 3 points";
      break;
    case CellError::OwnPoint:
      text << "point " << *FindUnlistedPoint(cell)
           << " of a face is not in the cell's list of points";
      break;
    case CellError::Degree:
      text << this->DescribeDegrees(cell);
      break;
    case CellError::Point:
      text << "point " << *FindPoint(cell, this->Points.IsBadPoint) << " is not finite";
      break;
    default:
      text << this->DescribeWeight(*FindPoint(cell, this->Points.IsBadWeight));
  }
  return text.str();
}

// Returns one sentence for each kind of fault.
template <typename Describe>
std::vector<std::string> DescribeErrors(
  const std::vector<CellError>& errors, const Describe& describe)
{
  std::vector<std::string> sentences;
  for (int k = 1; k < static_cast<int>(CellError::Number); ++k)
  {
    const CellError error = static_cast<CellError>(k);
    const auto first = std::find(errors.begin(), errors.end(), error);
    if (first != errors.end())
    {
      const auto others = std::count(first + 1, errors.end(), error);
      sentences.push_back(describe(first - errors.begin(), error) +
        (others == 0      ? "."
            : others == 1 ? ". 1 more cell has the same fault."
                          : ". " + std::to_string(others) + " more cells have the same fault."));
    }
  }
  return sentences;
}

CellUse GetUse(const CellKind& kind)
{
  return kind.IsSolid() ? CellUse::Solid : kind.IsSurface() ? CellUse::Surface : CellUse::None;
}

CellChecks CheckGrid(vtkUnstructuredGrid* grid, const CellDemands& demands)
{
  const vtkIdType number = std::max<vtkIdType>(grid->GetNumberOfCells(), 0);
  const GridChecks gridChecks(grid, demands);
  CellChecks checks;
  checks.Uses.resize(number, CellUse::None);
  std::vector<CellError> errors(number, CellError::None);
  vtkSMPTools::For(0, number,
    [&](vtkIdType first, vtkIdType end)
    {
      CellReader cell(grid);
      for (vtkIdType i = first; i < end; ++i)
      {
        if (gridChecks.IsHidden(i))
        {
          continue;
        }
        errors[i] = gridChecks.Find(cell, i);
        checks.Uses[i] = errors[i] == CellError::None ? GetUse(cell.GetKind()) : CellUse::None;
      }
    });
  checks.Errors = DescribeErrors(
    errors, [&](vtkIdType id, CellError error) { return gridChecks.Describe(id, error); });
  return checks;
}

// For structured data, and other data sets without lists of cells. Their cell types are valid.
CellChecks CheckIds(vtkDataSet* data)
{
  const vtkIdType points = data->GetNumberOfPoints();
  CellChecks checks;
  checks.Uses.resize(data->GetNumberOfCells(), CellUse::None);
  std::vector<CellError> errors(checks.Uses.size(), CellError::None);
  vtkNew<vtkIdList> ids;
  const auto find = [&](vtkIdType cell)
  {
    data->GetCellPoints(cell, ids);
    return std::find_if(
      ids->begin(), ids->end(), [=](vtkIdType id) { return id < 0 || id >= points; });
  };
  for (std::size_t i = 0; i < errors.size(); ++i)
  {
    const auto cell = static_cast<vtkIdType>(i);
    if (find(cell) == ids->end())
    {
      checks.Uses[i] = GetUse(GetCellKind(data->GetCellType(cell), ids->GetNumberOfIds()));
    }
    else
    {
      errors[i] = CellError::PointId;
    }
  }
  checks.Errors = DescribeErrors(errors,
    [&](vtkIdType cell, CellError)
    {
      return "Cell " + std::to_string(cell) + " (" + GetTypeName(data->GetCellType(cell)) +
        ") is left out: it refers to point " + std::to_string(*find(cell)) + ", but there are " +
        std::to_string(points) + " points";
    });
  return checks;
}
}

CellChecks CheckCells(vtkDataSet* data, const CellDemands& demands)
{
  if (auto* grid = vtkUnstructuredGrid::SafeDownCast(data))
  {
    return CheckGrid(grid, demands);
  }
  const auto number = static_cast<std::size_t>(std::max<vtkIdType>(data->GetNumberOfCells(), 0));
  if (vtkPolyData::SafeDownCast(data))
  {
    return { std::vector<CellUse>(number, CellUse::None), {} };
  }
  if (vtkImageData::SafeDownCast(data) || vtkRectilinearGrid::SafeDownCast(data))
  {
    return { std::vector<CellUse>(number, CellUse::Solid), {} };
  }
  return CheckIds(data);
}
}
