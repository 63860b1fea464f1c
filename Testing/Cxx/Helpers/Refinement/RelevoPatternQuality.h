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
  double Area;          // of the whole triangle's
  double SmallestAngle; // degrees
  double Aspect;        // longest side to smallest height, 1.15 at best

  /// Whether corners coincide or are on one line.
  bool IsDegenerate() const { return this->Area < 1e-12; }
};

/// Of each triangle. Areas count from the weights, positive if counter-clockwise.
std::vector<Shape> GetShapes(const relevo::RefinementPattern& pattern);

/// SUAPT (Lenz 2009, section 5): the uniform pattern of the highest of levels i >= j >= k, with
/// each border vertex moved to the nearest point of its edge's own level.
relevo::RefinementPattern MakeSuaptPattern(vtkRefinementPatternTable* table, const int levels[3]);
}

#endif
