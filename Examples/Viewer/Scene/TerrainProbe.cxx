// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/TerrainProbe.h"

#include "vtkDataArray.h"
#include "vtkHeightField.h"
#include "vtkIdList.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStaticCellLocator.h"

//------------------------------------------------------------------------------
TerrainProbe::TerrainProbe(vtkPolyData* mesh, vtkHeightField* heights)
  : Mesh(mesh)
  , Heights(heights)
{
  this->Locator->SetDataSet(mesh);
}

//------------------------------------------------------------------------------
TerrainProbe::~TerrainProbe() = default;

//------------------------------------------------------------------------------
bool TerrainProbe::GetHeight(double x, double y, double& height)
{
  this->Locator->BuildLocator();
  const double above[3] = { x, y, 1.0 };
  const double below[3] = { x, y, -1.0 };
  double t;
  double point[3];
  double place[3];
  int part;
  vtkIdType cell;
  const double onEdges = 1e-9 * this->Mesh->GetLength();
  if (!this->Locator->IntersectWithLine(above, below, onEdges, t, point, place, part, cell))
  {
    return false;
  }
  vtkNew<vtkIdList> corners;
  this->Mesh->GetCellPoints(cell, corners);
  // Weights in a triangle.
  const double weights[3] = { 1.0 - place[0] - place[1], place[0], place[1] };
  vtkDataArray* coordinates = this->Mesh->GetPointData()->GetTCoords();
  double uv[2] = { 0.0, 0.0 };
  for (int i = 0; i < 3; ++i)
  {
    for (int c = 0; c < 2; ++c)
    {
      uv[c] += weights[i] * coordinates->GetComponent(corners->GetId(i), c);
    }
  }
  height = this->Heights->GetHeight(uv[0], uv[1]);
  return this->Heights->IsValid(uv[0], uv[1]);
}
