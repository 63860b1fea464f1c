// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   control points as VTK's Bézier cells
 *
 * Private to the module's own sources.
 */
#ifndef BezierCells_h
#define BezierCells_h

#include "Mathematics/BezierDegree.h" // for callers
#include "Mathematics/RefinementMathematics.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <array>
#include <map>
#include <vector>

class vtkDoubleArray;
class vtkIntArray;
class vtkPoints;
class vtkUnstructuredGrid;

namespace relevo
{
/// Makes an unstructured grid, cell by cell.
class BezierCells
{
public:
  /// `grid` becomes empty, with points in double. Without `isRational` all weights are 1, and are
  /// left out.
  BezierCells(vtkUnstructuredGrid* grid, bool isRational);

  /// Control points: x, y, z and the weight, those of the first direction follow one another.
  /// Those of a border that equal those of another cell's, weights too, become one with them.
  void AddQuadrilateral(const ivec2& degrees, const std::vector<dvec4>& points);
  /// The same of a curve, whose borders are its ends.
  void AddCurve(int degree, const std::vector<dvec4>& points);

private:
  vtkIdType AddPoint(const dvec4& point, bool isBorder);
  void AddDegrees(int first, int second);

  vtkUnstructuredGrid* Grid;
  vtkSmartPointer<vtkPoints> Points;
  vtkSmartPointer<vtkIntArray> Degrees;
  vtkSmartPointer<vtkDoubleArray> Weights;
  std::map<std::array<double, 4>, vtkIdType> Borders;
};
}

#endif
