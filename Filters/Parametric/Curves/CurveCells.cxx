// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Curves/CurveCells.h"

#include "Compatibility/VTKCompatibility.h"
#include "Mathematics/BezierDegree.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace relevo
{
namespace
{
std::string GetText(double number)
{
  std::ostringstream text;
  text << number;
  return text.str();
}

std::string GetQuotedName(vtkDataArray* array)
{
  return '"' + std::string(array->GetName() ? array->GetName() : "") + '"';
}
}

CurveCells::CurveCells(vtkPointSet* input)
  : Input(input)
  , Grid(vtkUnstructuredGrid::SafeDownCast(input))
  , NumberOfCells(std::max<vtkIdType>(input->GetNumberOfCells(), 0))
  , Ghosts(vtkUnsignedCharArray::SafeDownCast(
      input->GetCellData()->GetArray(vtkDataSetAttributes::GhostArrayName())))
  , Degrees(input->GetCellData()->GetHigherOrderDegrees())
  , Weights(input->GetPointData()->GetRationalWeights())
{
  if (this->Grid)
  {
    this->Cells = this->Grid->GetCells();
    this->NumberOfTypes = GetNumberOfCellTypes(this->Grid);
  }
  else if (vtkPolyData* mesh = vtkPolyData::SafeDownCast(input))
  {
    this->Cells = mesh->GetLines();
    this->FirstCell = mesh->GetNumberOfVerts();
  }
}

int CurveCells::GetType(vtkIdType cell) const
{
  if (this->Grid)
  {
    return cell < this->NumberOfTypes ? this->Grid->GetCellType(cell) : VTK_EMPTY_CELL;
  }
  const vtkIdType line = cell - this->FirstCell;
  return line >= 0 && line < this->Cells->GetNumberOfCells() ? VTK_POLY_LINE : VTK_EMPTY_CELL;
}

CurveCells::Kinds CurveCells::GetKind(vtkIdType cell) const
{
  constexpr int notDrawn = vtkDataSetAttributes::DUPLICATECELL | vtkDataSetAttributes::HIDDENCELL;
  if (this->Ghosts && cell < this->Ghosts->GetNumberOfValues() &&
    (this->Ghosts->GetValue(cell) & notDrawn) != 0)
  {
    return NO_CURVE;
  }
  if (this->Grid && cell >= this->NumberOfTypes)
  {
    return UNKNOWN;
  }
  switch (this->GetType(cell))
  {
    case VTK_LINE:
    case VTK_POLY_LINE:
      return LINES;
    case VTK_QUADRATIC_EDGE:
    case VTK_CUBIC_LINE:
    case VTK_LAGRANGE_CURVE:
      return LAGRANGE;
    case VTK_BEZIER_CURVE:
      return BEZIER;
    case VTK_PARAMETRIC_CURVE:
    case VTK_HIGHER_ORDER_EDGE:
      return UNKNOWN;
    default:
      return NO_CURVE;
  }
}

void CurveCells::GetPoints(vtkIdType cell, Kinds kind, vtkIdList* points) const
{
  ReadCellPoints(this->Cells, cell - this->FirstCell, points);
  // VTK stores both ends first.
  const vtkIdType number = points->GetNumberOfIds();
  if (kind == LINES || number < 3)
  {
    return;
  }
  const vtkIdType last = points->GetId(1);
  for (vtkIdType i = 2; i < number; ++i)
  {
    points->SetId(i - 1, points->GetId(i));
  }
  points->SetId(number - 1, last);
}

double CurveCells::GetWeight(Kinds kind, vtkIdType point) const
{
  return kind == BEZIER && this->Weights ? this->Weights->GetComponent(point, 0) : 1.0;
}

std::string CurveCells::FindNumberError(vtkIdType cell, Kinds kind, vtkIdType number) const
{
  const int type = this->GetType(cell);
  const bool isFixed = type == VTK_LINE || type == VTK_QUADRATIC_EDGE || type == VTK_CUBIC_LINE;
  const vtkIdType wanted = type == VTK_CUBIC_LINE ? 4 : (type == VTK_QUADRATIC_EDGE ? 3 : 2);
  if (isFixed ? number != wanted : number < wanted)
  {
    return "has " + std::to_string(number) + " points, but needs " + std::to_string(wanted) +
      (isFixed ? "" : " or more");
  }
  if (isFixed || kind == LINES)
  {
    return std::string();
  }
  if (number > LargestDegree + 1)
  {
    return "has degree " + std::to_string(number - 1) + ", but the highest degree is " +
      std::to_string(LargestDegree);
  }
  const double degree = this->Degrees && cell < this->Degrees->GetNumberOfTuples()
    ? this->Degrees->GetComponent(cell, 0)
    : 0.0;
  return degree == 0.0 || degree == static_cast<double>(number - 1)
    ? std::string()
    : "has " + std::to_string(number) + " points, but degree " + GetText(degree) +
      " in cell array " + GetQuotedName(this->Degrees);
}

std::string CurveCells::FindPointError(Kinds kind, vtkIdType point) const
{
  if (point < 0 || point >= this->Input->GetNumberOfPoints())
  {
    return "refers to point " + std::to_string(point) + ", but there are " +
      std::to_string(this->Input->GetNumberOfPoints()) + " points";
  }
  double x[3];
  this->Input->GetPoint(point, x);
  if (!std::isfinite(x[0]) || !std::isfinite(x[1]) || !std::isfinite(x[2]))
  {
    return "has point " + std::to_string(point) + ", which is not finite";
  }
  if (kind != BEZIER || !this->Weights)
  {
    return std::string();
  }
  if (point >= this->Weights->GetNumberOfTuples())
  {
    return "has point " + std::to_string(point) + ", for which point array " +
      GetQuotedName(this->Weights) + " has no weight";
  }
  const double weight = this->GetWeight(kind, point);
  return weight > 0.0 && std::isfinite(weight)
    ? std::string()
    : "has the weight " + GetText(weight) + " at point " + std::to_string(point) +
      " in point array " + GetQuotedName(this->Weights) + "; weights must be positive and finite";
}

std::string CurveCells::FindError(vtkIdType cell, Kinds kind, vtkIdList* points) const
{
  const bool isListed = !this->Grid || cell < this->NumberOfTypes;
  vtkNew<vtkIdList> read;
  if (!isListed ||
    (points->GetNumberOfIds() == 0 && !ReadCellPoints(this->Cells, cell - this->FirstCell, read)))
  {
    return "cannot be read: the arrays of cell types, offsets and point ids are too short for it, "
           "or "
           "its offsets decrease";
  }
  if (kind == UNKNOWN)
  {
    return "is a curve of VTK's cell type " + std::to_string(this->GetType(cell)) +
      ", which is not supported";
  }
  const vtkIdType number = points->GetNumberOfIds();
  std::string error = this->FindNumberError(cell, kind, number);
  for (vtkIdType i = 0; error.empty() && i < number; ++i)
  {
    error = this->FindPointError(kind, points->GetId(i));
  }
  return error;
}
}
