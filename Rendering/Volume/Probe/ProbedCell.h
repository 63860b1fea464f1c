// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @struct  ProbedCell
 * @brief   the parametric coordinates of a point in a cell of a data set
 *
 * Private to the module.
 */
#ifndef ProbedCell_h
#define ProbedCell_h

#include "Mathematics/RefinementMathematics.h"
#include "vtkType.h"

class vtkDataSet;

namespace relevo
{
struct ProbedCell
{
  vtkIdType Id = -1;
  int SubId = 0;
  dvec3 Parameters = dvec3(0.0);
  /// The point of the cell with the largest weight.
  vtkIdType NearestPoint = -1;

  /// Find the coordinates by VTK's functions of the cell, to double precision.
  static ProbedCell Find(vtkDataSet* mesh, vtkIdType cell, const dvec3& point);
};
}

#endif
