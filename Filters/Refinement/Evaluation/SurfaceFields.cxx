// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Evaluation/SurfaceFields.h"

#include "Arrays/NearestTuple.h"
#include "Arrays/NoDataTuples.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

namespace relevo
{
namespace
{
// Replaces missing values by NaN. This makes the field NaN in their whole patches, because each
// coefficient mixes several nodes.
void MarkNoData(double noDataMagnitude, vtkSmartPointer<vtkDataArray>& coefficients)
{
  const NoDataTuples noData(coefficients, noDataMagnitude);
  if (noData.IsEmpty())
  {
    return;
  }
  vtkNew<vtkDoubleArray> marked;
  marked->DeepCopy(coefficients);
  for (vtkIdType i = 0; i < marked->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; noData.GetMarks()[i] && c < marked->GetNumberOfComponents(); ++c)
    {
      marked->SetComponent(i, c, vtkMath::Nan());
    }
  }
  coefficients = marked;
}
}

SurfaceFields::SurfaceFields(
  vtkRefinementSurface* surface, vtkPolyData* mesh, double noDataMagnitude, vtkPointData* to)
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
      this->Fields.push_back({ coefficients, values });
      if (CanLackData(from, array))
      {
        MarkNoData(noDataMagnitude, this->Fields.back().Coefficients);
      }
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
        continue; // corners have exact values
      }
      this->Surface->EvaluateField(face, point.Weights, field.Coefficients, tuple.data());
      SetNearestTuple(field.Values, point.Id, tuple.data());
    }
  }
}
}
