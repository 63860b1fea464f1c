// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RelevoCurvatures.h"

#include "vtkCellArray.h"
#include "vtkCurvatureDepthTagMetric.h"
#include "vtkDoubleArray.h"
#include "vtkLinearSubdivisionFilter.h"
#include "vtkPlatonicSolidSource.h"
#include "vtkPolygon.h"
#include "vtkReverseSense.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace RelevoCurvatures
{
Mesh MakeMesh(std::initializer_list<std::vector<double>> coordinates,
  std::initializer_list<std::vector<vtkIdType>> polygons)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const auto& x : coordinates)
  {
    points->InsertNextPoint(x.data());
  }
  vtkNew<vtkCellArray> cells;
  for (const auto& polygon : polygons)
  {
    cells->InsertNextCell(static_cast<vtkIdType>(polygon.size()), polygon.data());
  }
  auto mesh = Mesh::New();
  mesh->SetPoints(points);
  mesh->SetPolys(cells);
  return mesh;
}

Mesh MakeGrid(
  int columns, int rows, const std::function<void(double u, double v, double x[3])>& map)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  for (int row = 0; row <= rows; ++row)
  {
    for (int column = 0; column <= columns; ++column)
    {
      double x[3];
      map(static_cast<double>(column) / columns, static_cast<double>(row) / rows, x);
      const vtkIdType id = points->InsertNextPoint(x);
      if (column < columns && row < rows)
      {
        const vtkIdType quad[4] = { id, id + 1, id + columns + 2, id + columns + 1 };
        cells->InsertNextCell(4, quad);
      }
    }
  }
  auto mesh = Mesh::New();
  mesh->SetPoints(points);
  mesh->SetPolys(cells);
  return mesh;
}

Mesh MakeTorus(double ringRadius, double radius, int columns, int rows)
{
  return MakeGrid(columns, rows,
    [=](double u, double v, double x[3])
    {
      const double a = 2 * Pi * std::fmod(u, 1.0);
      const double b = 2 * Pi * std::fmod(v, 1.0);
      x[0] = (ringRadius + radius * std::cos(b)) * std::cos(a);
      x[1] = (ringRadius + radius * std::cos(b)) * std::sin(a);
      x[2] = radius * std::sin(b);
    });
}

Mesh MakeSphere(double radius, int subdivisions)
{
  vtkNew<vtkPlatonicSolidSource> solid;
  solid->SetSolidTypeToIcosahedron();
  vtkNew<vtkLinearSubdivisionFilter> subdivision;
  subdivision->SetInputConnection(solid->GetOutputPort());
  subdivision->SetNumberOfSubdivisions(subdivisions);
  subdivision->Update();
  auto mesh = Mesh::New();
  mesh->CopyStructure(subdivision->GetOutput());
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (vtkIdType id = 0; id < mesh->GetNumberOfPoints(); ++id)
  {
    double x[3];
    mesh->GetPoint(id, x);
    vtkMath::Normalize(x);
    vtkMath::MultiplyScalar(x, radius);
    points->InsertNextPoint(x);
  }
  mesh->SetPoints(points);
  // VTK's icosahedron faces inwards in 9.1 and outwards in 9.6.
  double normal[3];
  vtkPolygon::ComputeNormal(mesh->GetCell(0)->GetPoints(), normal);
  vtkNew<vtkReverseSense> outwards;
  outwards->SetReverseCells(vtkMath::Dot(normal, mesh->GetCell(0)->GetPoints()->GetPoint(0)) < 0.0);
  outwards->SetInputData(mesh);
  outwards->Update();
  return outwards->GetOutput();
}

std::vector<double> Curvatures(vtkPolyData* mesh, int type)
{
  vtkNew<vtkCurvatureDepthTagMetric> metric;
  metric->SetCurvatureType(type);
  vtkNew<vtkDoubleArray> curvatures;
  metric->ComputeCurvatures(mesh, curvatures);
  return { curvatures->GetPointer(0), curvatures->GetPointer(0) + curvatures->GetNumberOfTuples() };
}

std::vector<double> Gaussian(vtkPolyData* mesh)
{
  return Curvatures(mesh, vtkCurvatureDepthTagMetric::GAUSSIAN);
}

std::vector<double> Mean(vtkPolyData* mesh)
{
  return Curvatures(mesh, vtkCurvatureDepthTagMetric::MEAN);
}

double LargestError(
  const std::vector<double>& values, const std::function<double(size_t)>& expected)
{
  double error = 0.0;
  for (size_t i = 0; i < values.size(); ++i)
  {
    error = std::max(error, std::abs(values[i] - expected(i)));
  }
  return error;
}

double LargestDifference(const std::vector<double>& a, const std::vector<double>& b)
{
  return a.size() == b.size() ? LargestError(a, [&b](size_t i) { return b[i]; })
                              : std::numeric_limits<double>::infinity();
}
}
