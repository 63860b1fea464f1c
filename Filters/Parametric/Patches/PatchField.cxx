// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Patches/PatchField.h"

#include "Patches/PatchTables.h"
#include "vtkDataArray.h"

#include <algorithm>

namespace relevo
{
namespace
{
dvec3 GetCoefficients(vtkDataArray* coefficients, int i, int first)
{
  dvec3 values(0.0);
  for (int c = 0; c < std::min(coefficients->GetNumberOfComponents() - first, 3); ++c)
  {
    values[c] = coefficients->GetComponent(i, first + c);
  }
  return values;
}
}

vec4 PatchField::patchPoint(int i) const
{
  const float weight = this->Tables.Points[4 * static_cast<std::size_t>(i) + 3];
  const dvec3 values = GetCoefficients(this->Coefficients, i, this->First) - this->Origin;
  return vec4(vec3(values) * weight, weight);
}

void EvaluatePatchField(const vtkRefinementSurface::Face& face, const float weights[3],
  vtkDataArray* coefficients, double* tuple)
{
  PatchFace functions(face);
  const PatchFace::FacePatch patch = functions.facePatch();
  const vec2 uv = functions.patchCoordinate(patch, PatchCorners::Load(weights));
  const int components = coefficients->GetNumberOfComponents();
  for (int first = 0; first < components; first += 3)
  {
    PatchField field{ *face.MeshTables, coefficients, first,
      GetCoefficients(coefficients, patch.Shape.First, first) };
    const PatchField::PatchShape shape{ patch.Shape.First, patch.Shape.Degrees,
      patch.Shape.IsTriangle };
    const vec4 point = field.patchPointAt(shape, uv).Point;
    const dvec3 values = dvec3(vec3(point) / point.w) + field.Origin;
    for (int c = 0; c < std::min(components - first, 3); ++c)
    {
      tuple[first + c] = values[c];
    }
  }
}
}
