// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Whether a pattern keeps what RefinementPattern.h says.
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

// Twice the area in the triangle (0,0), (1,0), (0,1): exact for multiples of 2^-24.
double Area(const Triple& a, const Triple& b, const Triple& c);

// Indices of the vertices on edge 1, 2 or 3, from corner to corner.
std::vector<unsigned int> EdgeVertices(const relevo::RefinementPattern& pattern, int edge);

// Exact weights, in the pattern's order, each once.
void CheckVertices(RelevoCheck& check, const relevo::RefinementPattern& pattern);

// A conforming, counter-clockwise triangulation, and its lines.
void CheckTriangles(RelevoCheck& check, const relevo::RefinementPattern& pattern);
}

#endif
