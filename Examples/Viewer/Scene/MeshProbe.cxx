// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/MeshProbe.h"

#include "vtkAdaptiveRefinement.h"
#include "vtkCamera.h"
#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkGenericCell.h"
#include "vtkPolyData.h"
#include "vtkRefinedCellLocator.h"
#include "vtkRenderer.h"

#include <algorithm>

//------------------------------------------------------------------------------
MeshProbe::MeshProbe(
  vtkPolyData* mesh, vtkAdaptiveRefinement* recipe, vtkDataArray* array, bool isOfPoints)
  : Array(array)
  , IsOfPoints(isOfPoints)
{
  this->Locator->SetDataSet(mesh);
  this->Locator->SetRefinement(recipe);
  // These warnings were shown when the mesh was drawn.
  this->Locator->AddObserver(vtkCommand::WarningEvent, this, &MeshProbe::Ignore);
}

//------------------------------------------------------------------------------
MeshProbe::~MeshProbe() = default;

//------------------------------------------------------------------------------
vtkIdType MeshProbe::FindFace(
  const double place[3], vtkRenderer* renderer, vtkGenericCell* cell, double* weights)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  this->Locator->SetCamera(camera);
  this->Locator->SetViewportSize(renderer->GetSize());
  const double depths = 1e-3; // possible error of a pixel's depth, relative to the distance
  double start[3];
  double end[3];
  for (int i = 0; i < 3; ++i)
  {
    const double sight = camera->GetParallelProjection()
      ? camera->GetDistance() * camera->GetDirectionOfProjection()[i]
      : place[i] - camera->GetPosition()[i];
    start[i] = place[i] - depths * sight;
    end[i] = place[i] + depths * sight;
  }
  vtkIdType face = -1;
  int part = 0;
  double t;
  double inCell[3];
  double point[3];
  if (this->Locator->IntersectWithLine(start, end, 0.0, t, point, inCell, part, face, cell))
  {
    cell->EvaluateLocation(part, inCell, point, weights);
    return face;
  }
  // The face is seen edge-on.
  double distance2;
  double nearest[3];
  this->Locator->FindClosestPoint(place, nearest, cell, face, part, distance2);
  if (face >= 0)
  {
    cell->EvaluatePosition(nearest, point, part, inCell, distance2, weights);
  }
  return face;
}

//------------------------------------------------------------------------------
vtkIdType MeshProbe::Find(const double place[3], vtkRenderer* renderer, std::vector<double>& value)
{
  value.clear();
  vtkNew<vtkGenericCell> cell;
  vtkPolyData* mesh = vtkPolyData::SafeDownCast(this->Locator->GetDataSet());
  std::vector<double> weights(static_cast<size_t>(std::max(mesh->GetMaxCellSize(), 3)));
  const vtkIdType face = this->FindFace(place, renderer, cell, weights.data());
  if (face < 0 || !this->Array)
  {
    return face;
  }
  value.resize(static_cast<size_t>(this->Array->GetNumberOfComponents()));
  if (!this->IsOfPoints)
  {
    this->Array->GetTuple(face, value.data());
    return face;
  }
  for (vtkIdType i = 0; i < cell->GetNumberOfPoints(); ++i)
  {
    for (size_t c = 0; c < value.size(); ++c)
    {
      value[c] += weights[static_cast<size_t>(i)] *
        this->Array->GetComponent(cell->GetPointId(i), static_cast<int>(c));
    }
  }
  return face;
}
