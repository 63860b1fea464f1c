// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "MeshProbe.h"

#include "vtkDataArray.h"
#include "vtkGenericCell.h"
#include "vtkPolyData.h"
#include "vtkStaticCellLocator.h"

//------------------------------------------------------------------------------
MeshProbe::MeshProbe(vtkPolyData* mesh, vtkDataArray* array, bool isOfPoints)
  : Array(array)
  , IsOfPoints(isOfPoints)
{
  this->Locator->SetDataSet(mesh);
}

//------------------------------------------------------------------------------
MeshProbe::~MeshProbe() = default;

//------------------------------------------------------------------------------
std::vector<double> MeshProbe::GetValue(const double place[3])
{
  this->Locator->BuildLocator();
  double onFace[3];
  double distance2;
  int part;
  vtkIdType face = -1;
  vtkNew<vtkGenericCell> cell;
  this->Locator->FindClosestPoint(place, onFace, cell, face, part, distance2);
  if (face < 0)
  {
    return {};
  }
  std::vector<double> value(static_cast<size_t>(this->Array->GetNumberOfComponents()));
  if (!this->IsOfPoints)
  {
    this->Array->GetTuple(face, value.data());
    return value;
  }
  double inCell[3];
  double nearest[3];
  std::vector<double> weights(static_cast<size_t>(cell->GetNumberOfPoints()));
  cell->EvaluatePosition(onFace, nearest, part, inCell, distance2, weights.data());
  for (vtkIdType i = 0; i < cell->GetNumberOfPoints(); ++i)
  {
    for (size_t c = 0; c < value.size(); ++c)
    {
      value[c] += weights[i] * this->Array->GetComponent(cell->GetPointId(i), static_cast<int>(c));
    }
  }
  return value;
}
