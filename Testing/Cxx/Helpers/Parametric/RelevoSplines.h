// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Curves and surfaces by their definitions, and as VTK's own cells have them.
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

/// Where VTK's cell has the parametric coordinates u and v.
RelevoPosition RelevoEvaluateCell(vtkUnstructuredGrid* grid, vtkIdType cell, double u, double v);

/// A NURBS of control points, first direction first, with all that vtkNURBSSource needs.
struct RelevoSpline
{
  std::array<int, 2> Degrees{ 3, 3 };
  std::array<int, 2> Dimensions{ 1, 1 };
  std::array<std::vector<double>, 2> Knots; ///< of a curve, the second are empty
  std::vector<RelevoPosition> Points;
  std::vector<double> Weights; ///< empty: all 1

  vtkSmartPointer<vtkNURBSSource> NewSource() const;
  /// By the recursion of Cox and de Boor, from the left of a knot where `fromLeft`.
  RelevoPosition Evaluate(double u, double v, bool fromLeft = false) const;
  /// The spans that are not empty, where the spline is defined.
  std::vector<std::array<double, 2>> GetSpans(int direction) const;
};

/// Control points and, if `isRational`, weights by chance.
RelevoSpline RelevoMakeRandomSpline(std::mt19937& random, const std::array<int, 2>& degrees,
  const std::array<std::vector<double>, 2>& knots, bool isRational);

/// A full circle of radius 1 around the origin in the plane of x and y, of four quadratic arcs.
RelevoSpline RelevoMakeCircle();

/// A torus around the z axis: the circle swept along one of radius `radius`, its own is `tube`.
RelevoSpline RelevoMakeTorus(double radius, double tube);

#endif
