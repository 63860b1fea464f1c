// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @struct  PatchField
 * @brief   a point array's coefficients, evaluated by the patches' basis in C++
 *
 * Private to the module's own sources.
 */
#ifndef PatchField_h
#define PatchField_h

#include "Mathematics/RefinementMathematics.h"
#include "vtkRefinementSurface.h"

class vtkDataArray;

namespace relevo
{
/// Three components at a time, from `First` on.
struct PatchField
{
  vec4 patchPoint(int i) const;

  const vtkRefinementSurface::Tables& Tables;
  vtkDataArray* Coefficients;
  int First;
  dvec3 Origin; // less is lost

#include "glsl/relevoPatch.glsl"
};

/// See vtkRefinementSurface::EvaluateField().
void EvaluatePatchField(const vtkRefinementSurface::Face& face, const float weights[3],
  vtkDataArray* coefficients, double* tuple);
}

#endif
