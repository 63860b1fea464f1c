// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RelevoGeographicMesh.h"

#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

vtkSmartPointer<vtkDoubleArray> RelevoMakeArray(
  const std::string& name, const std::vector<std::vector<double>>& tuples)
{
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName(name.c_str());
  array->SetNumberOfComponents(tuples.empty() ? 3 : static_cast<int>(tuples[0].size()));
  for (const std::vector<double>& tuple : tuples)
  {
    array->InsertNextTuple(tuple.data());
  }
  return array;
}

vtkSmartPointer<vtkPolyData> RelevoMakePoints(const std::vector<std::array<double, 2>>& places)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const auto& place : places)
  {
    points->InsertNextPoint(place[0], place[1], 0.0);
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  return mesh;
}

std::array<double, 3> RelevoVectorOf(vtkPolyData* mesh, vtkIdType point, const char* name)
{
  std::array<double, 3> vector = { 0.0, 0.0, 0.0 };
  vtkDataArray* array = mesh->GetPointData()->GetArray(name);
  if (array && array->GetNumberOfComponents() == 3 && point < array->GetNumberOfTuples())
  {
    array->GetTuple(point, vector.data());
  }
  return vector;
}
