// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   BenchmarkPatchReference
 * @brief   scalars where rays meet the faces of cells, by vtkCell's own formulas
 */
#ifndef BenchmarkPatchReference_h
#define BenchmarkPatchReference_h

#include "vtkNew.h"
#include "vtkType.h"

#include <array>

class vtkGenericCell;
class vtkUnstructuredGrid;

class BenchmarkPatchReference
{
public:
  using Place = std::array<double, 3>;

  /// Of BenchmarkPatchMeshes::MakeHexahedra(), whose outer faces count.
  explicit BenchmarkPatchReference(vtkUnstructuredGrid* grid);
  ~BenchmarkPatchReference();

  /// Where the ray from `eye` through `point` meets a cell next to `point`, by Newton's method; NaN
  /// where it does not.
  double FindValue(const Place& eye, const Place& point, vtkIdType cell);

private:
  struct Hit
  {
    bool IsFound = false;
    double Parameter = 0.0; // along the ray, 1 at the point
    double Value = 0.0;
  };
  Hit MeetFace(const Place& eye, const Place& point, int axis, bool atEnd);
  Place Evaluate(const Place& parametric, double weights[]);

  vtkUnstructuredGrid* Grid;
  vtkIdType Side;
  vtkNew<vtkGenericCell> Cell;
  vtkIdType CellId = -1;
};

#endif
