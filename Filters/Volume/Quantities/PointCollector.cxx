// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Quantities/PointCollector.h"

#include "Quantities/GaussPoints.h"
#include "Quantities/QuadratureScheme.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkQuadratureSchemeDefinition.h"

#include <vector>

namespace relevo
{
PointCollector::PointCollector(const std::string& arrayName)
  : Name(arrayName)
{
  this->Points->SetDataTypeToDouble();
  this->Cells->SetName("vtkOriginalCellIds");
}

PointCollector::~PointCollector() = default;

vtkIdType PointCollector::GetNumberOfPoints() const
{
  return this->Points->GetNumberOfPoints();
}

std::string PointCollector::Add(vtkDataSet* data)
{
  for (vtkDataArray* values : FindIntegrationPointArrays(data))
  {
    if (values->GetName() == this->Name)
    {
      return this->AddField(data, values);
    }
  }
  vtkDataArray* ofCells = data->GetCellData()->GetArray(this->Name.c_str());
  return ofCells ? this->AddCells(data, ofCells) : "";
}

std::string PointCollector::Prepare(vtkDataArray* values, int components)
{
  if (!this->Values)
  {
    this->Values = vtkSmartPointer<vtkDataArray>::Take(values->NewInstance());
    this->Values->SetName(this->Name.c_str());
    this->Values->SetNumberOfComponents(components);
    if (values->HasInformation())
    {
      this->Values->CopyInformation(values->GetInformation()); // with the unit
    }
  }
  return this->Values->GetNumberOfComponents() == components
    ? ""
    : "it has " + std::to_string(this->Values->GetNumberOfComponents()) +
      " components in one block and " + std::to_string(components) + " in another";
}

std::string PointCollector::AddField(vtkDataSet* data, vtkDataArray* values)
{
  const QuadratureScheme scheme(data, values);
  std::string error = scheme.GetError();
  error = error.empty() ? this->Prepare(values, values->GetNumberOfComponents()) : error;
  vtkNew<vtkIdList> nodes;
  for (vtkIdType cell = 0; error.empty() && cell < data->GetNumberOfCells(); ++cell)
  {
    vtkQuadratureSchemeDefinition* definition = scheme.GetDefinition(cell);
    if (!definition)
    {
      continue;
    }
    data->GetCellPoints(cell, nodes);
    if (nodes->GetNumberOfIds() != definition->GetNumberOfNodes())
    {
      return "cell " + std::to_string(cell) + " has " + std::to_string(nodes->GetNumberOfIds()) +
        " nodes, but its quadrature scheme " + std::to_string(definition->GetNumberOfNodes());
    }
    for (int i = 0; i < definition->GetNumberOfQuadraturePoints(); ++i)
    {
      const double* weights = definition->GetShapeFunctionWeights(i);
      double place[3] = { 0.0, 0.0, 0.0 };
      for (vtkIdType node = 0; node < nodes->GetNumberOfIds(); ++node)
      {
        double point[3];
        data->GetPoint(nodes->GetId(node), point);
        for (int axis = 0; axis < 3; ++axis)
        {
          place[axis] += weights[node] * point[axis];
        }
      }
      this->Points->InsertNextPoint(place);
      this->Cells->InsertNextValue(cell);
      this->Values->InsertNextTuple(scheme.GetFirst(cell) + i, values);
    }
  }
  return error;
}

std::string PointCollector::AddCells(vtkDataSet* data, vtkDataArray* values)
{
  const std::string error = this->Prepare(values, 1);
  const int number = values->GetNumberOfComponents();
  vtkNew<vtkGenericCell> cell;
  std::vector<double> weights;
  for (vtkIdType i = 0; error.empty() && i < data->GetNumberOfCells(); ++i)
  {
    data->GetCell(i, cell);
    const int type = cell->GetCellType();
    const auto places = FindGaussPoints(GetCellKind(type, cell->GetNumberOfPoints()).Shape, number);
    if (places.empty() || i >= values->GetNumberOfTuples())
    {
      ++this->OtherCells[cell->GetRepresentativeCell()->GetClassName()];
      continue;
    }
    weights.resize(static_cast<std::size_t>(cell->GetNumberOfPoints()));
    for (int k = 0; k < number; ++k)
    {
      int part = 0;
      double place[3];
      cell->EvaluateLocation(part, places[k].data(), place, weights.data());
      this->Points->InsertNextPoint(place);
      this->Cells->InsertNextValue(i);
      const double value = values->GetComponent(i, k);
      this->Values->InsertNextTuple(&value);
    }
  }
  return error;
}

void PointCollector::Finish(vtkPolyData* output)
{
  vtkNew<vtkCellArray> vertices;
  for (vtkIdType i = 0; i < this->GetNumberOfPoints(); ++i)
  {
    vertices->InsertNextCell(1, &i);
  }
  output->SetPoints(this->Points);
  output->SetVerts(vertices);
  output->GetPointData()->SetScalars(this->Values);
  output->GetPointData()->AddArray(this->Cells);
}
}
