// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Evaluation/SurfaceFields.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <cmath>

namespace relevo
{
SurfaceFields::SurfaceFields(vtkRefinementSurface* surface, vtkPolyData* mesh, vtkPointData* to)
  : Surface(surface)
{
  vtkPointData* from = mesh->GetPointData();
  for (int a = 0; surface && a < from->GetNumberOfArrays(); ++a)
  {
    vtkDataArray* array = from->GetArray(a);
    vtkDataArray* coefficients = array ? surface->FindCoefficients(mesh, array) : nullptr;
    vtkDataArray* values = coefficients ? to->GetArray(array->GetName()) : nullptr;
    if (values)
    {
      const int type = values->GetDataType();
      this->Fields.push_back({ coefficients, values, type != VTK_FLOAT && type != VTK_DOUBLE });
    }
  }
}

void SurfaceFields::Evaluate(
  const vtkRefinementSurface::Face& face, const std::vector<RefinedPoint>& points) const
{
  std::vector<double> tuple;
  for (const Field& field : this->Fields)
  {
    tuple.resize(static_cast<std::size_t>(field.Values->GetNumberOfComponents()));
    for (const RefinedPoint& point : points)
    {
      if (point.Weights[point.GetNearestCorner()] == 1.0f)
      {
        continue; // corners have their own
      }
      this->Surface->EvaluateField(face, point.Weights, field.Coefficients, tuple.data());
      for (std::size_t c = 0; c < tuple.size(); ++c)
      {
        field.Values->SetComponent(
          point.Id, static_cast<int>(c), field.IsInteger ? std::round(tuple[c]) : tuple[c]);
      }
    }
  }
}
}
