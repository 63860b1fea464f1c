// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RelevoBusyVolumes.h"

#include "RelevoDice.h"

#include "vtkColorTransferFunction.h"
#include "vtkDelaunay3D.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <cmath>

vtkSmartPointer<vtkVolumeProperty> MakeBusyProperty(double unitDistance, int components)
{
  auto property = vtkSmartPointer<vtkVolumeProperty>::New();
  for (int c = 0; c < components; ++c)
  {
    vtkNew<vtkColorTransferFunction> color;
    vtkNew<vtkPiecewiseFunction> opacity;
    for (int i = 0; i <= 10; ++i)
    {
      color->AddRGBPoint(0.1 * i, (i + c) % 2, (i + c) % 3 / 2.0, (i + 2 * c) % 5 / 4.0);
      opacity->AddPoint(0.1 * i, (i * 7 + 3 * c) % 11 / 10.0);
    }
    opacity->AddPoint(0.55, 0.0);
    opacity->AddPoint(0.5501, 1.0);
    opacity->AddPoint(0.5502, 0.0);
    property->SetColor(c, color);
    property->SetScalarOpacity(c, opacity);
    property->SetScalarOpacityUnitDistance(c, unitDistance * (1.0 + 0.3 * c));
  }
  return property;
}

double GetWaves(const RelevoPoint& at)
{
  return 0.5 + 0.5 * std::sin(3.0 * at[0]) * std::cos(2.0 * at[1] + at[2]);
}

vtkSmartPointer<vtkUnstructuredGrid> MakeBall(int numberOfPoints, double low)
{
  RelevoDice dice(7);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> values;
  values->SetName("waves");
  while (points->GetNumberOfPoints() < numberOfPoints)
  {
    const RelevoPoint at = { { dice.Signed(), dice.Signed(), dice.Signed() } };
    if (at[0] * at[0] + at[1] * at[1] + at[2] * at[2] < 1.0)
    {
      points->InsertNextPoint(low + at[0], low + at[1], low + at[2]);
      values->InsertNextValue(GetWaves(at));
    }
  }
  vtkNew<vtkPolyData> cloud;
  cloud->SetPoints(points);
  cloud->GetPointData()->SetScalars(values);
  vtkNew<vtkDelaunay3D> delaunay;
  delaunay->SetInputData(cloud);
  delaunay->Update();
  return delaunay->GetOutput();
}

vtkSmartPointer<vtkDoubleArray> MakeBusyArray(vtkPointSet* mesh, int components)
{
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName("busy");
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(mesh->GetNumberOfPoints());
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    RelevoPoint at;
    mesh->GetPoint(i, at.data());
    for (int c = 0; c < components; ++c)
    {
      const size_t k = static_cast<size_t>(c);
      array->SetComponent(i, c, GetWaves({ { at[k % 3], at[(k + 1) % 3] + 0.3 * c, at[2] } }));
    }
  }
  return array;
}
