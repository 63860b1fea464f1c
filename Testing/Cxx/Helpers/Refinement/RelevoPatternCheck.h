// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Checks that a pattern satisfies the conditions of RefinementPattern.h.
#ifndef RelevoPatternCheck_h
#define RelevoPatternCheck_h

#include "RelevoCheck.h"

#include "Patterns/RefinementPattern.h"

#include <array>
#include <utility>
#include <vector>

namespace RelevoPatternCheck
{
using Triple = std::array<float, 3>;
using Side = std::pair<unsigned int, unsigned int>;

Triple Weights(const relevo::RefinementPattern& pattern, unsigned int vertex);

// Twice the area in the triangle (0, 0), (1, 0), (0, 1). Exact for multiples of 2^-24.
double Area(const Triple& a, const Triple& b, const Triple& c);

// Indices of the vertices on edge 1, 2 or 3, from corner to corner.
std::vector<unsigned int> EdgeVertices(const relevo::RefinementPattern& pattern, int edge);

// Weights are exact, in the pattern's order, and unique.
void CheckVertices(RelevoCheck& check, const relevo::RefinementPattern& pattern);

// The triangulation is conforming and counter-clockwise, and its lines are correct.
void CheckTriangles(RelevoCheck& check, const relevo::RefinementPattern& pattern);
}

#endif
