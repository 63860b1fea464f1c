// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   LatticeCollapse
 * @brief   removes vertices of a mesh of a grid within a vertical tolerance
 *
 * A vertex is removed by the collapse of an edge into one of its neighbours, if the triangles that
 * replace those around it are within the tolerance and are not too narrow. Vertices at the border
 * of the mesh remain, and so do those next to triangles that reach beyond the grid.
 *
 * The surface of the grid is bilinear in each cell. In the part of a cell that a triangle covers,
 * the distance from it has no extremum inside. So the distances at samples and along the edges of
 * triangles bound all others.
 *
 * Private to the module.
 */
#ifndef LatticeCollapse_h
#define LatticeCollapse_h

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace relevo
{
class LatticeCollapse
{
public:
  /// Column and row in units of a cell divided by 2^subdivisions.
  using Vertex = std::array<std::int64_t, 2>;
  using Triangle = std::array<Vertex, 3>;

  /// The grid must remain in memory.
  LatticeCollapse(const std::vector<float>& heights, int columns, int rows, int subdivisions);

  /// Remove vertices of a mesh whose triangles are within the tolerance. Returns false if
  /// `isAborted` has returned true.
  bool Collapse(
    std::vector<Triangle>& triangles, double tolerance, const std::function<bool()>& isAborted);

private:
  static constexpr int None = -1;

  /// A vertex of the ring, and the distance at the vertex that is removed if the ring becomes a fan
  /// around it.
  struct Candidate
  {
    int Index;
    double Distance;
  };

  void Connect(const std::vector<Triangle>& triangles);
  double Interpolate(double x, double y) const;
  bool FindRing(int vertex);
  bool Remove(int vertex);
  double MeasureAt(const Vertex& point, int first) const;
  bool IsFanWithin(int first) const;
  bool IsTriangleWithin(const int ids[3]) const;
  bool IsEdgeWithin(int first, int second) const;

  const std::vector<float>& Heights;
  int Columns;
  int Rows;
  int Subdivisions;
  double Tolerance = 0.0;
  std::vector<Vertex> Vertices;
  std::vector<double> VertexHeights;
  std::vector<int> Corners; // three vertices per triangle; None if it has been removed
  std::vector<int> First;   // of each vertex, a corner that it is at
  std::vector<int> Next;    // of each corner, another one at the same vertex
  std::vector<int> Ring;    // the vertices around one, in the order of the triangles
  std::vector<Candidate> Candidates;
};
}

#endif
