// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/BezierCells.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkHigherOrderQuadrilateral.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

namespace relevo
{
BezierCells::BezierCells(vtkUnstructuredGrid* grid, bool isRational)
  : Grid(grid)
  , Points(vtkSmartPointer<vtkPoints>::New())
  , Degrees(vtkSmartPointer<vtkIntArray>::New())
  , Weights(vtkSmartPointer<vtkDoubleArray>::New())
{
  this->Points->SetDataTypeToDouble();
  grid->Initialize();
  grid->SetPoints(this->Points);
  grid->Allocate(1);
  this->Degrees->SetName("HigherOrderDegrees");
  this->Degrees->SetNumberOfComponents(3);
  grid->GetCellData()->SetHigherOrderDegrees(this->Degrees);
  if (isRational)
  {
    this->Weights->SetName("RationalWeights");
    grid->GetPointData()->SetRationalWeights(this->Weights);
  }
}

vtkIdType BezierCells::AddPoint(const dvec4& point, bool isBorder)
{
  const vtkIdType next = this->Points->GetNumberOfPoints();
  if (isBorder)
  {
    const auto [place, isNew] =
      this->Borders.insert({ { point.x, point.y, point.z, point.w }, next });
    if (!isNew)
    {
      return place->second;
    }
  }
  this->Points->InsertNextPoint(point.x, point.y, point.z);
  if (this->Grid->GetPointData()->GetRationalWeights())
  {
    this->Weights->InsertNextValue(point.w);
  }
  return next;
}

void BezierCells::AddDegrees(int first, int second)
{
  const std::array<double, 3> degrees{ static_cast<double>(first), static_cast<double>(second),
    0.0 };
  this->Degrees->InsertNextTuple(degrees.data());
}

void BezierCells::AddQuadrilateral(const ivec2& degrees, const std::vector<dvec4>& points)
{
  const std::array<int, 2> order{ degrees.x, degrees.y };
  std::vector<vtkIdType> ids(points.size());
  std::size_t next = 0;
  for (int j = 0; j <= degrees.y; ++j)
  {
    for (int i = 0; i <= degrees.x; ++i)
    {
      const bool isBorder = i == 0 || i == degrees.x || j == 0 || j == degrees.y;
      ids[vtkHigherOrderQuadrilateral::PointIndexFromIJK(i, j, order.data())] =
        this->AddPoint(points[next++], isBorder);
    }
  }
  this->Grid->InsertNextCell(
    VTK_BEZIER_QUADRILATERAL, static_cast<vtkIdType>(ids.size()), ids.data());
  this->AddDegrees(degrees.x, degrees.y);
}

void BezierCells::AddCurve(int degree, const std::vector<dvec4>& points)
{
  // VTK stores both ends first.
  std::vector<vtkIdType> ids{ this->AddPoint(points.front(), true),
    this->AddPoint(points.back(), true) };
  for (std::size_t i = 1; i + 1 < points.size(); ++i)
  {
    ids.push_back(this->AddPoint(points[i], false));
  }
  this->Grid->InsertNextCell(VTK_BEZIER_CURVE, static_cast<vtkIdType>(ids.size()), ids.data());
  this->AddDegrees(degree, 0);
}
}
