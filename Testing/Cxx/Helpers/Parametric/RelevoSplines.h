// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Curves and surfaces by their definitions, and as VTK's cells evaluate them.
#ifndef RelevoSplines_h
#define RelevoSplines_h

#include "vtkNURBSSource.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <array>
#include <random>
#include <vector>

class vtkUnstructuredGrid;

using RelevoPosition = std::array<double, 3>;

double RelevoGetDistance(const RelevoPosition& a, const RelevoPosition& b);

/// Position of VTK's cell at the parametric coordinates u and v.
RelevoPosition RelevoEvaluateCell(vtkUnstructuredGrid* grid, vtkIdType cell, double u, double v);

/// A NURBS with everything that vtkNURBSSource needs. Control points run along the first direction
/// first.
struct RelevoSpline
{
  std::array<int, 2> Degrees{ 3, 3 };
  std::array<int, 2> Dimensions{ 1, 1 };
  std::array<std::vector<double>, 2> Knots; ///< the second are empty for a curve
  std::vector<RelevoPosition> Points;
  std::vector<double> Weights; ///< empty: all are 1

  vtkSmartPointer<vtkNURBSSource> NewSource() const;
  /// Evaluates by the Cox-de Boor recursion, at a knot from the left if `fromLeft`.
  RelevoPosition Evaluate(double u, double v, bool fromLeft = false) const;
  /// The non-empty spans for which the spline is defined.
  std::vector<std::array<double, 2>> GetSpans(int direction) const;
};

/// Random control points and, if `isRational`, random weights.
RelevoSpline RelevoMakeRandomSpline(std::mt19937& random, const std::array<int, 2>& degrees,
  const std::array<std::vector<double>, 2>& knots, bool isRational);

/// A circle of radius 1 around the origin in the x-y plane, made of four quadratic arcs.
RelevoSpline RelevoMakeCircle();

/// A torus around the z axis: a circle of radius `tube` swept along one of radius `radius`.
RelevoSpline RelevoMakeTorus(double radius, double tube);

#endif
