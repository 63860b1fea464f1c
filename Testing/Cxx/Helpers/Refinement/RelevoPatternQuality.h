// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Shapes of patterns' triangles in the equilateral triangle, and SUAPT's patterns.
#ifndef RelevoPatternQuality_h
#define RelevoPatternQuality_h

#include "Patterns/RefinementPattern.h"
#include "vtkRefinementPatternTable.h"

#include <vector>

namespace RelevoPatternQuality
{
struct Shape
{
  double Area;          // relative to the whole triangle
  double SmallestAngle; // degrees
  double Aspect;        // longest side over smallest height, at best 1.15

  /// Whether corners coincide or are collinear.
  bool IsDegenerate() const { return this->Area < 1e-12; }
};

/// Shape of each triangle. Areas are computed from the weights, positive if counter-clockwise.
std::vector<Shape> GetShapes(const relevo::RefinementPattern& pattern);

/// SUAPT (Lenz 2009, section 5): the uniform pattern of the highest of the levels i >= j >= k, with
/// each border vertex moved to the nearest point of its edge's level.
relevo::RefinementPattern MakeSuaptPattern(vtkRefinementPatternTable* table, const int levels[3]);
}

#endif
