// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   BenchmarkPatchReference
 * @brief   scalars where rays hit the faces of cells, by vtkCell's formulas
 */
#ifndef BenchmarkPatchReference_h
#define BenchmarkPatchReference_h

#include "vtkNew.h"
#include "vtkType.h"

#include <array>

class vtkGenericCell;
class vtkIdList;
class vtkStaticPointLocator;
class vtkUnstructuredGrid;

class BenchmarkPatchReference
{
public:
  using Place = std::array<double, 3>;

  /// For the outer faces of BenchmarkPatchMeshes::MakeHexahedra().
  explicit BenchmarkPatchReference(vtkUnstructuredGrid* grid);
  ~BenchmarkPatchReference();

  /// The scalar where the ray from `eye` through `point` hits a cell at the node closest to
  /// `point`, by Newton's method. NaN if it misses.
  double FindValue(const Place& eye, const Place& point);

private:
  struct Hit
  {
    bool IsFound = false;
    double Parameter = 0.0; // along the ray, 1 at the point
    double Value = 0.0;
  };
  static Hit Choose(const Hit& first, const Hit& second);
  Hit MeetCell(const Place& eye, const Place& point, vtkIdType cell);
  Hit MeetFace(const Place& eye, const Place& point, int axis, bool atEnd);
  Place Evaluate(const Place& parametric, double weights[]);

  vtkUnstructuredGrid* Grid;
  vtkIdType Side;
  vtkNew<vtkGenericCell> Cell;
  vtkNew<vtkStaticPointLocator> Nodes;
  vtkNew<vtkIdList> CellsAtNode;
};

#endif
