// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Probe/ProbedCell.h"

#include "vtkCellType.h"
#include "vtkDataSet.h"
#include "vtkGenericCell.h"
#include "vtkNew.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace relevo
{
namespace
{
constexpr int MaximumSteps = 12;
constexpr double Converged = 1e-14;
constexpr double Difference = 1e-5; // of parameters

class CellFunctions
{
public:
  CellFunctions(vtkGenericCell* cell, int subId)
    : Cell(cell)
    , SubId(subId)
    , Weights(static_cast<size_t>(std::max<vtkIdType>(cell->GetNumberOfPoints(), 1)))
  {
  }

  dvec3 At(const dvec3& parameters)
  {
    dvec3 point(0.0);
    this->Cell->EvaluateLocation(this->SubId, &parameters.x, &point.x, this->Weights.data());
    return point;
  }

  // VTK lacks the derivatives of some rational cells.
  dmat3 Derive(const dvec3& parameters)
  {
    dmat3 derivatives(0.0);
    for (int axis = 0; axis < 3; ++axis)
    {
      dvec3 step(0.0);
      step[axis] = Difference;
      derivatives[axis] =
        (this->At(parameters + step) - this->At(parameters - step)) / (2.0 * Difference);
    }
    return derivatives;
  }

  // Newton's method, because vtkCell::EvaluatePosition() stops early. Steps that do not come nearer
  // are undone.
  dvec3 Refine(dvec3 parameters, const dvec3& point)
  {
    double miss = distance(this->At(parameters), point);
    for (int i = 0; i < MaximumSteps && miss > 0.0; ++i)
    {
      const dvec3 step = inverse(this->Derive(parameters)) * (point - this->At(parameters));
      const double now = distance(this->At(parameters + step), point);
      if (!(now < miss))
      {
        break;
      }
      parameters += step;
      miss = now;
      if (dot(step, step) < Converged * Converged)
      {
        break;
      }
    }
    return parameters;
  }

  vtkIdType FindNearestPoint(const dvec3& parameters)
  {
    this->At(parameters);
    const auto largest = std::max_element(this->Weights.begin(), this->Weights.end());
    return this->Cell->GetPointId(static_cast<int>(largest - this->Weights.begin()));
  }

private:
  vtkGenericCell* Cell;
  int SubId;
  std::vector<double> Weights;
};
}

ProbedCell ProbedCell::Find(vtkDataSet* mesh, vtkIdType id, const dvec3& point)
{
  vtkNew<vtkGenericCell> cell;
  mesh->GetCell(id, cell);
  ProbedCell found;
  found.Id = id;
  double distance2;
  std::vector<double> weights(
    static_cast<size_t>(std::max<vtkIdType>(cell->GetNumberOfPoints(), 1)));
  dvec3 parameters(0.0);
  dvec3 closest;
  const int state = cell->EvaluatePosition(
    &point.x, &closest.x, found.SubId, &parameters.x, distance2, weights.data());
  const int type = cell->GetCellType();
  const bool isSplit = type == VTK_POLYHEDRON || type == VTK_CONVEX_POINT_SET;
  CellFunctions functions(cell, found.SubId);
  if (!isSplit)
  {
    dvec3 center(0.5);
    cell->GetParametricCenter(&center.x);
    const bool isFinite = std::isfinite(parameters.x + parameters.y + parameters.z);
    parameters = functions.Refine(state >= 0 && isFinite ? parameters : center, point);
  }
  found.Parameters = parameters;
  found.NearestPoint = functions.FindNearestPoint(parameters);
  return found;
}
}
