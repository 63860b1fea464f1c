// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @struct  PatchField
 * @brief   evaluation of point arrays in the basis of a patch, in C++
 *
 * Private to the module.
 */
#ifndef PatchField_h
#define PatchField_h

#include "Mathematics/RefinementMathematics.h"
#include "vtkRefinementSurface.h"

class vtkDataArray;

namespace relevo
{
/// Evaluates three components at a time, starting at `First`.
struct PatchField
{
  vec4 patchPoint(int i) const;

  const vtkRefinementSurface::Tables& Tables;
  vtkDataArray* Coefficients;
  int First;
  dvec3 Origin; // values are relative to it for precision

#include "glsl/relevoPatch.glsl"
};

/// See vtkRefinementSurface::EvaluateField().
void EvaluatePatchField(const vtkRefinementSurface::Face& face, const float weights[3],
  vtkDataArray* coefficients, double* tuple);
}

#endif
