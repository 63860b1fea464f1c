// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Draping/DrapedOutput.h"

#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>

namespace relevo
{
DrapedOutput::DrapedOutput(vtkPolyData* input, double offset)
  : Input(input)
  , Offset(offset)
{
  this->Points->SetDataTypeToDouble();
  this->Heights->SetName("Height");
  // The directions of the input are not those of the surface.
  this->PointData->CopyNormalsOff();
  this->PointData->InterpolateAllocate(input->GetPointData());
}

vtkIdType DrapedOutput::AddPoint(const SurfacePoint& point, const Source& source)
{
  const vtkIdType id = this->Points->InsertNextPoint(point.GetWorld(this->Offset).data());
  this->Heights->InsertNextValue(point.GetHeight());
  this->SourceIds->SetNumberOfIds(source.Count);
  for (int i = 0; i < source.Count; ++i)
  {
    this->SourceIds->SetId(i, source.Ids[i]);
  }
  std::array<double, 3> weights = source.Weights;
  this->PointData->InterpolatePoint(
    this->Input->GetPointData(), id, this->SourceIds, weights.data());
  return id;
}

bool DrapedOutput::IsStep(vtkIdType id, const SurfacePoint& point) const
{
  constexpr double tolerance = 1e-6;
  const double height = point.GetHeight();
  return std::abs(this->Heights->GetValue(id) - height) >
    tolerance * std::max(1.0, std::abs(height));
}

void DrapedOutput::AddCell(Kinds kind, const std::vector<vtkIdType>& points, vtkIdType source)
{
  this->Cells[kind]->InsertNextCell(static_cast<vtkIdType>(points.size()), points.data());
  this->CellSources.push_back(source);
}

void DrapedOutput::Finish(vtkPolyData* output)
{
  output->SetPoints(this->Points);
  output->SetVerts(this->Cells[VERTICES]);
  output->SetLines(this->Cells[LINES]);
  output->SetPolys(this->Cells[POLYGONS]);
  output->GetPointData()->ShallowCopy(this->PointData);
  output->GetPointData()->AddArray(this->Heights);
  vtkCellData* cells = output->GetCellData();
  cells->CopyNormalsOff();
  cells->CopyAllocate(this->Input->GetCellData(), this->GetNumberOfCells());
  for (vtkIdType id = 0; id < this->GetNumberOfCells(); ++id)
  {
    cells->CopyData(this->Input->GetCellData(), this->CellSources[id], id);
  }
  output->GetFieldData()->ShallowCopy(this->Input->GetFieldData());
}
}
