// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RelevoMicroMeshes.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkGenericCell.h"
#include "vtkIntArray.h"
#include "vtkMicroMeshFilter.h"
#include "vtkMicroMeshSurface.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkStaticCellLocator.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace RelevoMicroMeshes
{
Mesh ReliefSphere(int theta, int phi)
{
  Mesh mesh = RelevoMeshes::Sphere(theta, phi);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double x[3];
    mesh->GetPoint(i, x);
    const double size = std::sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
    double height = 0.04;
    for (int c = 0; c < 3; ++c)
    {
      x[c] /= size;
      height *= std::sin((7.0 + c) * x[c] + 0.3);
    }
    for (double& coordinate : x)
    {
      coordinate *= 1.0 + height;
    }
    mesh->GetPoints()->SetPoint(i, x);
  }
  mesh->GetPointData()->Initialize();
  return mesh;
}

Mesh Plate(int n)
{
  std::vector<std::array<double, 3>> points;
  std::vector<RelevoMeshes::Triangle> triangles;
  for (int j = 0; j <= n; ++j)
  {
    for (int i = 0; i <= n; ++i)
    {
      const double x = 2.0 * i / n - 1.0;
      const double y = 2.0 * j / n - 1.0 + 0.1 * std::sin(4.0 * x) * j / n;
      const double wave = x * x * 0.2 * std::sin(6.0 * y);
      points.push_back({ { x, y, std::abs(x) + wave } });
    }
  }
  for (int j = 0; j < n; ++j)
  {
    for (int i = 0; i < n; ++i)
    {
      const vtkIdType a = j * (n + 1) + i;
      triangles.push_back({ { a, a + 1, a + n + 2 } });
      triangles.push_back({ { a, a + n + 2, a + n + 1 } });
    }
  }
  Mesh mesh = RelevoMeshes::FromTriangles(points, triangles);
  vtkNew<vtkIntArray> materials;
  materials->SetName("Material");
  for (int j = 0; j < n; ++j)
  {
    for (int i = 0; i < n; ++i)
    {
      const int material = j > n / 2 + std::lround(0.2 * n * std::sin(5.0 * i / n)) ? 1 : 0;
      materials->InsertNextValue(material);
      materials->InsertNextValue(material);
    }
  }
  mesh->GetCellData()->AddArray(materials);
  return mesh;
}

Mesh Encode(
  vtkPolyData* dense, double tolerance, int maximumLevel, double reduction, const char* materials)
{
  vtkNew<vtkMicroMeshFilter> filter;
  filter->SetInputData(dense);
  filter->SetTolerance(tolerance);
  filter->SetMaximumLevel(maximumLevel);
  filter->SetTargetReduction(reduction);
  filter->SetMaterialArrayName(materials);
  filter->Update();
  return filter->GetOutput();
}

Mesh Decode(vtkPolyData* micro, int level)
{
  vtkNew<vtkMicroMeshSurface> surface;
  return RelevoMeshes::Refine(micro, RelevoMeshes::MakeRecipe(level, surface));
}

double GetDistance(vtkPolyData* from, vtkPolyData* to)
{
  if (to->GetNumberOfCells() == 0)
  {
    return std::numeric_limits<double>::infinity();
  }
  vtkNew<vtkStaticCellLocator> locator;
  locator->SetDataSet(to);
  locator->BuildLocator();
  vtkNew<vtkGenericCell> cell;
  double largest = 0.0;
  const auto measure = [&](double x[3])
  {
    double closest[3];
    double distance2;
    vtkIdType id;
    int part;
    locator->FindClosestPoint(x, closest, cell, id, part, distance2);
    largest = std::max(largest, distance2);
  };
  // Scans can have points without triangles.
  std::vector<char> areMeasured(static_cast<size_t>(from->GetNumberOfPoints()), 0);
  for (vtkIdType i = 0; i < from->GetNumberOfCells(); ++i)
  {
    vtkIdType size;
    const vtkIdType* ids;
    from->GetCellPoints(i, size, ids);
    if (size < 3)
    {
      continue; // a vertex or a line
    }
    double middle[3] = { 0.0, 0.0, 0.0 };
    for (int corner = 0; corner < 3; ++corner)
    {
      double x[3];
      from->GetPoint(ids[corner], x);
      char& isMeasured = areMeasured[static_cast<size_t>(ids[corner])];
      if (isMeasured == 0)
      {
        isMeasured = 1;
        measure(x);
      }
      std::transform(x, x + 3, middle, middle, [](double a, double b) { return a / 3.0 + b; });
    }
    measure(middle);
  }
  return std::sqrt(largest);
}

namespace
{
int CountDifferentArrays(vtkFieldData* a, vtkFieldData* b)
{
  int number = std::abs(a->GetNumberOfArrays() - b->GetNumberOfArrays());
  for (int i = 0; i < a->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* one = a->GetArray(i);
    vtkDataArray* other = b->GetArray(one->GetName());
    if (!other || one->GetDataType() != other->GetDataType() ||
      one->GetNumberOfComponents() != other->GetNumberOfComponents() ||
      one->GetNumberOfTuples() != other->GetNumberOfTuples())
    {
      ++number;
      continue;
    }
    for (vtkIdType t = 0; t < one->GetNumberOfTuples(); ++t)
    {
      for (int c = 0; c < one->GetNumberOfComponents(); ++c)
      {
        number += one->GetComponent(t, c) != other->GetComponent(t, c) ? 1 : 0;
      }
    }
  }
  return number;
}
}

int CountDifferences(vtkPolyData* a, vtkPolyData* b)
{
  if (a->GetNumberOfPoints() != b->GetNumberOfPoints() ||
    a->GetNumberOfCells() != b->GetNumberOfCells())
  {
    return 1;
  }
  int number = CountDifferentArrays(a->GetPointData(), b->GetPointData()) +
    CountDifferentArrays(a->GetCellData(), b->GetCellData()) +
    CountDifferentArrays(a->GetFieldData(), b->GetFieldData());
  for (vtkIdType i = 0; i < a->GetNumberOfPoints(); ++i)
  {
    double x[3];
    double y[3];
    a->GetPoint(i, x);
    b->GetPoint(i, y);
    number += std::equal(x, x + 3, y) ? 0 : 1;
  }
  for (vtkIdType i = 0; i < a->GetNumberOfCells(); ++i)
  {
    vtkIdType sizes[2];
    const vtkIdType* ids[2];
    a->GetCellPoints(i, sizes[0], ids[0]);
    b->GetCellPoints(i, sizes[1], ids[1]);
    number += sizes[0] == sizes[1] && std::equal(ids[0], ids[0] + sizes[0], ids[1]) ? 0 : 1;
  }
  return number;
}
}
