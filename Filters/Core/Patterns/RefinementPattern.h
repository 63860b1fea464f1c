// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @struct  RefinementPattern
 * @brief   one subdivided triangle, as plain data
 *
 * Vertices are barycentric triples (u, v, w) for (P1, P2, P3), each triple summing to 1 exactly
 * in float. Their order is fixed: the three corners; the inner points of edge 1 (from P1 to P2),
 * of edge 2 (P2 to P3) and of edge 3 (P3 to P1); then the points inside. A point on an edge has an
 * exact zero for the corner opposite, and the same bits from either end: point k of n weighs its
 * far corner as point n - k weighs the near one. Inner weights of adaptive patterns are multiples
 * of 2^-12, so that products of two are exact in float.
 */
#ifndef RefinementPattern_h
#define RefinementPattern_h

#include <memory> // for RefinementPatterns
#include <vector> // for members

namespace relevo
{
struct RefinementPattern
{
  /// Segments on edges 1, 2, 3; in descending order but in nested patterns (NestedPattern.h).
  int Segments[3] = { 1, 1, 1 };
  /// Barycentric triples, 3 floats a vertex.
  std::vector<float> Vertices;
  /// Counter-clockwise triangles (with P1 = (0,0), P2 = (1,0), P3 = (0,1)), 3 vertices each, in an
  /// order that suits a cache of transformed vertices.
  std::vector<unsigned int> Triangles;
  /// Every undirected edge of the triangulation once, 2 vertices each: first the segments of the
  /// pattern's edges 1, 2 and 3, in order, then the edges inside.
  std::vector<unsigned int> Lines;

  int GetNumberOfVertices() const { return static_cast<int>(this->Vertices.size() / 3); }
  int GetNumberOfTriangles() const { return static_cast<int>(this->Triangles.size() / 3); }
  /// Vertices on the border: they come first.
  int GetNumberOfBorderVertices() const
  {
    return this->Segments[0] + this->Segments[1] + this->Segments[2];
  }
};

/// Patterns never change, and belong to all who have a pointer to them.
using RefinementPatterns = std::vector<std::shared_ptr<const RefinementPattern>>;
}

#endif
