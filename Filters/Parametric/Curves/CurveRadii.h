// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   radii of ribbons and tubes along curves
 *
 * Private to the modules.
 */
#ifndef CurveRadii_h
#define CurveRadii_h

#include "RelevoFiltersParametricModule.h" // for export macro

#include <string>

class vtkDataArray;
class vtkPointSet;

namespace relevo
{
/// Returns the point array of this name, with a radius for each point, or nullptr with an `error`
/// if it is invalid.
RELEVOFILTERSPARAMETRIC_EXPORT vtkDataArray* FindCurveRadii(
  vtkPointSet* input, const std::string& name, std::string& error);
}

#endif
