// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   creation of VTK Bézier cells from control points
 *
 * Private to the module.
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
/// Builds an unstructured grid cell by cell.
class BezierCells
{
public:
  /// Clears `grid`, which gets double points. If not `isRational`, all weights are 1 and are not
  /// stored.
  BezierCells(vtkUnstructuredGrid* grid, bool isRational);

  /// Adds a patch. Control points are x, y, z and weight, ordered along the first direction first.
  /// Border points are merged with those of other cells if coordinates and weights are equal.
  void AddQuadrilateral(const ivec2& degrees, const std::vector<dvec4>& points);
  /// Adds a curve in the same way. Its end points are its border.
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
