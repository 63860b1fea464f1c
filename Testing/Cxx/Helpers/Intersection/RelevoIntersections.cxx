// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RelevoIntersections.h"

#include "vtkCell.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolygon.h"

#include <cmath>

vtkSmartPointer<vtkPolyData> RelevoMakePolygons(const std::vector<std::array<double, 3>>& points,
  const std::vector<std::vector<vtkIdType>>& cells)
{
  vtkNew<vtkPoints> places;
  places->SetDataTypeToDouble();
  for (const auto& point : points)
  {
    places->InsertNextPoint(point.data());
  }
  vtkNew<vtkCellArray> polygons;
  for (const auto& cell : cells)
  {
    polygons->InsertNextCell(static_cast<vtkIdType>(cell.size()), cell.data());
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(places);
  mesh->SetPolys(polygons);
  return mesh;
}

vtkSmartPointer<vtkPolyData> RelevoMakeBox(double low, double high)
{
  std::vector<std::array<double, 3>> points;
  for (int i = 0; i < 8; ++i)
  {
    points.push_back({ i & 1 ? high : low, i & 2 ? high : low, i & 4 ? high : low });
  }
  return RelevoMakePolygons(points,
    { { 0, 2, 3, 1 }, { 4, 5, 7, 6 }, { 0, 1, 5, 4 }, { 2, 6, 7, 3 }, { 0, 4, 6, 2 },
      { 1, 3, 7, 5 } });
}

vtkSmartPointer<vtkPolyData> RelevoMakeSphere(
  int resolution, std::array<double, 3> center, double radius)
{
  std::vector<std::array<double, 3>> points;
  std::vector<std::vector<vtkIdType>> cells;
  const int columns = 2 * resolution;
  const auto add = [&](double polar, double azimuth)
  {
    points.push_back({ center[0] + radius * std::sin(polar) * std::cos(azimuth),
      center[1] + radius * std::sin(polar) * std::sin(azimuth),
      center[2] + radius * std::cos(polar) });
  };
  add(0.0, 0.0);
  add(vtkMath::Pi(), 0.0);
  const auto at = [&](int row, int column) -> vtkIdType {
    return row == 0 ? 0 : row == resolution ? 1 : 2 + (row - 1) * columns + column % columns;
  };
  for (int row = 1; row < resolution; ++row)
  {
    for (int column = 0; column < columns; ++column)
    {
      add(vtkMath::Pi() * row / resolution, vtkMath::Pi() * column / resolution);
    }
  }
  for (int row = 0; row < resolution; ++row)
  {
    for (int column = 0; column < columns; ++column)
    {
      if (row > 0)
      {
        cells.push_back({ at(row, column), at(row + 1, column), at(row, column + 1) });
      }
      if (row + 1 < resolution)
      {
        cells.push_back({ at(row, column + 1), at(row + 1, column), at(row + 1, column + 1) });
      }
    }
  }
  return RelevoMakePolygons(points, cells);
}

vtkSmartPointer<vtkMatrix4x4> RelevoMakeMotion(
  std::array<double, 3> translation, double degrees, std::array<double, 3> axis, double scale)
{
  const double radians = vtkMath::RadiansFromDegrees(degrees);
  vtkMath::Normalize(axis.data());
  const double quaternion[4] = { std::cos(radians / 2), axis[0] * std::sin(radians / 2),
    axis[1] * std::sin(radians / 2), axis[2] * std::sin(radians / 2) };
  double rotation[3][3];
  vtkMath::QuaternionToMatrix3x3(quaternion, rotation);
  auto matrix = vtkSmartPointer<vtkMatrix4x4>::New();
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      matrix->SetElement(i, j, scale * rotation[i][j]);
    }
    matrix->SetElement(i, 3, translation[i]);
  }
  return matrix;
}

vtkSmartPointer<vtkPolyData> RelevoMove(vtkPolyData* mesh, vtkMatrix4x4* matrix)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double x[4] = { 0.0, 0.0, 0.0, 1.0 };
    mesh->GetPoint(i, x);
    matrix->MultiplyPoint(x, x);
    points->InsertNextPoint(x);
  }
  auto moved = vtkSmartPointer<vtkPolyData>::New();
  moved->ShallowCopy(mesh);
  moved->SetPoints(points);
  return moved;
}

double RelevoMeasureArea(vtkPolyData* mesh)
{
  double area = 0.0;
  for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
  {
    vtkCell* cell = mesh->GetCell(i);
    double normal[3];
    area += vtkPolygon::ComputeArea(cell->GetPoints(), cell->GetNumberOfPoints(), nullptr, normal);
  }
  return area;
}

double RelevoMeasureLength(vtkPolyData* mesh)
{
  double length = 0.0;
  for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
  {
    vtkPoints* points = mesh->GetCell(i)->GetPoints();
    for (vtkIdType j = 1; j < points->GetNumberOfPoints(); ++j)
    {
      double ends[2][3];
      points->GetPoint(j - 1, ends[0]);
      points->GetPoint(j, ends[1]);
      length += std::sqrt(vtkMath::Distance2BetweenPoints(ends[0], ends[1]));
    }
  }
  return length;
}

std::set<std::pair<vtkIdType, vtkIdType>> RelevoGetCellPairs(
  vtkPolyData* mesh, const char* first, const char* second)
{
  std::set<std::pair<vtkIdType, vtkIdType>> pairs;
  vtkDataArray* firsts = mesh->GetCellData()->GetArray(first);
  vtkDataArray* seconds = mesh->GetCellData()->GetArray(second);
  for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
  {
    pairs.emplace(static_cast<vtkIdType>(firsts->GetComponent(i, 0)),
      static_cast<vtkIdType>(seconds->GetComponent(i, 0)));
  }
  return pairs;
}

bool RelevoIsSameMesh(vtkPolyData* mesh, vtkPolyData* other)
{
  bool isSame = mesh->GetNumberOfPoints() == other->GetNumberOfPoints() &&
    mesh->GetNumberOfCells() == other->GetNumberOfCells() &&
    mesh->GetCellData()->GetNumberOfArrays() == other->GetCellData()->GetNumberOfArrays();
  for (vtkIdType i = 0; isSame && i < mesh->GetNumberOfPoints(); ++i)
  {
    double x[3], y[3];
    mesh->GetPoint(i, x);
    other->GetPoint(i, y);
    isSame = x[0] == y[0] && x[1] == y[1] && x[2] == y[2];
  }
  for (vtkIdType i = 0; isSame && i < mesh->GetNumberOfCells(); ++i)
  {
    vtkNew<vtkIdList> own, others;
    mesh->GetCellPoints(i, own);
    other->GetCellPoints(i, others);
    isSame = mesh->GetCellType(i) == other->GetCellType(i) &&
      own->GetNumberOfIds() == others->GetNumberOfIds();
    for (vtkIdType j = 0; isSame && j < own->GetNumberOfIds(); ++j)
    {
      isSame = own->GetId(j) == others->GetId(j);
    }
    for (int k = 0; isSame && k < mesh->GetCellData()->GetNumberOfArrays(); ++k)
    {
      isSame = mesh->GetCellData()->GetArray(k)->GetComponent(i, 0) ==
        other->GetCellData()->GetArray(k)->GetComponent(i, 0);
    }
  }
  return isSame;
}
