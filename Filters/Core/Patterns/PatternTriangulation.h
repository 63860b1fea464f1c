// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   PatternTriangulation
 * @brief   a Delaunay triangulation of points in the triangle
 *
 * Points are inserted one by one, and edges are flipped until every circle is empty (Lawson 1977),
 * with exact predicates. If four points lie on one circle, the order of insertion decides.
 */
#ifndef PatternTriangulation_h
#define PatternTriangulation_h

#include "Patterns/PatternPoint.h"

#include <utility>
#include <vector>

namespace relevo
{
class PatternTriangulation
{
public:
  struct Triangle
  {
    int Vertex[3];   // counter-clockwise
    int Neighbor[3]; // opposite to the vertex; -1 outside
  };

  /// Create the triangle of the three corners.
  PatternTriangulation();

  /// Add a point inside or on the border, unless it exists.
  void Insert(PatternPoint p);

  /// Flip edges until the triangulation is Delaunay again, after points have moved without flipping
  /// a triangle.
  void MakeDelaunay();

  /// Get the triangles around an inner vertex, counter-clockwise, as pairs of the other two
  /// vertices.
  void GetStar(int vertex, std::vector<std::pair<int, int>>& star) const;

  std::vector<PatternPoint> Points;
  std::vector<Triangle> Triangles;

private:
  /// The triangles (a, b, c) and (d, c, b) at a side bc, and those across their other sides.
  struct Diamond
  {
    int Other = -1; // (d, c, b); at the border -1, as are D and the neighbours
    int A = -1, B = -1, C = -1, D = -1;
    int AcrossAB = -1, AcrossCA = -1;
    int AcrossBD = -1, AcrossDC = -1;
  };

  static int Next(int i) { return (i + 1) % 3; }
  static int Previous(int i) { return (i + 2) % 3; }

  int Locate(PatternPoint p) const;
  int IndexOf(int triangle, int vertex) const;
  int IndexOfNeighbor(int triangle, int neighbor) const;
  void Set(int triangle, int a, int b, int c, int na, int nb, int nc);
  void Link(int triangle, int former, int current);
  Diamond GetDiamond(int triangle, int side) const;
  void SplitTriangle(int triangle, int vertex);
  void SplitSide(int triangle, int side, int vertex);
  void Legalize();
  void LegalizeSide(int triangle, int side);

  std::vector<int> TriangleOfVertex;         // one triangle at each vertex
  std::vector<std::pair<int, int>> Suspects; // triangle, vertex opposite to the side to check
};
}

#endif
