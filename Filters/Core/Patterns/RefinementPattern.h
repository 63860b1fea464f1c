// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @struct  RefinementPattern
 * @brief   one subdivided triangle, as plain data
 *
 * Vertices are barycentric triples (u, v, w) for (P1, P2, P3). Each triple sums to exactly 1 in
 * float. The order is fixed: the three corners, the points on edge 1 (from P1 to P2), on edge 2
 * (P2 to P3) and on edge 3 (P3 to P1), then the points inside. A point on an edge has an exact 0
 * for the opposite corner, and the same bits from both ends: the weight of the far corner at point
 * k of n equals the weight of the near corner at point n - k. Inner weights of adaptive patterns
 * are multiples of 2^-12, so that products of two are exact in float.
 */
#ifndef RefinementPattern_h
#define RefinementPattern_h

#include <memory> // for RefinementPatterns
#include <vector> // for members

namespace relevo
{
struct RefinementPattern
{
  /// Segments on edges 1, 2, 3. They are in descending order, except in nested patterns
  /// (NestedPattern.h).
  int Segments[3] = { 1, 1, 1 };
  /// Barycentric triples, 3 floats per vertex.
  std::vector<float> Vertices;
  /// Counter-clockwise triangles (with P1 = (0,0), P2 = (1,0), P3 = (0,1)), 3 vertices each, in an
  /// order for the cache of transformed vertices.
  std::vector<unsigned int> Triangles;
  /// Every undirected edge of the triangulation once, 2 vertices each: first the segments of the
  /// pattern's edges 1, 2 and 3, in order, then the edges inside.
  std::vector<unsigned int> Lines;

  int GetNumberOfVertices() const { return static_cast<int>(this->Vertices.size() / 3); }
  int GetNumberOfTriangles() const { return static_cast<int>(this->Triangles.size() / 3); }
  /// The number of vertices on the border, which come first.
  int GetNumberOfBorderVertices() const
  {
    return this->Segments[0] + this->Segments[1] + this->Segments[2];
  }
};

/// Patterns never change and are shared.
using RefinementPatterns = std::vector<std::shared_ptr<const RefinementPattern>>;
}

#endif
