// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @struct  BaseMesh
 * @brief   a simplified mesh, prepared for displacements
 *
 * Coordinates of points are rounded to multiples of a length far below the tolerance, so that files
 * are small. Locked and fixed points, those that represent no other ones, and those at slivers keep
 * theirs.
 *
 * Levels are those at which the dense mesh is sampled: about one triangle of the grids per triangle
 * of the dense mesh, or more where levels are raised. They are 0 where nothing is displaced: on
 * lines, and on triangles and edges of the dense mesh that are left unchanged.
 */
#ifndef BaseMesh_h
#define BaseMesh_h

#include "Data/MicroMesh.h"
#include "Dense/DenseMesh.h"

namespace relevo
{
class EdgeCollapse;

struct BaseMesh
{
  /// `step` is the length of a displacement of 1. Directions are the mean normals of the dense mesh
  /// around each point, with octahedral coordinates of 8 bits.
  BaseMesh(const DenseMesh& dense, EdgeCollapse& collapse, double step);

  /// Set the levels. `raises` are added per face.
  void ChooseLevels(int maximumLevel, const std::vector<int>& raises);

  /// Whether a face is a triangle of the dense mesh, unchanged.
  bool IsOriginal(const MicroMesh::Face& face) const
  {
    return this->AreSingle[static_cast<std::size_t>(face.Corners[0])] != 0 &&
      this->AreSingle[static_cast<std::size_t>(face.Corners[1])] != 0 &&
      this->AreSingle[static_cast<std::size_t>(face.Corners[2])] != 0;
  }

  MicroMesh Mesh; // without samples
  /// The points in the coordinates of the input.
  std::vector<dvec3> Places;
  /// The vertex of the dense mesh per point, and whether it represents no other vertex.
  std::vector<int> Vertices;
  std::vector<char> AreSingle;
  /// The number of triangles of the dense mesh per point, divided by that of its coarse triangles.
  std::vector<double> Densities;
  /// The triangle of the dense mesh per face, whose cell data the face has.
  std::vector<int> Triangles;
  /// The points of the input at the corners of each face.
  std::vector<DenseMesh::Triangle> Wedges;
  /// Flags of DenseMesh per edge.
  std::vector<unsigned char> EdgeFlags;

private:
  void AddPoints(const DenseMesh& dense, EdgeCollapse& collapse, double step);
  std::vector<double> FindHeights(const DenseMesh& dense) const;
  void AddPoint(const DenseMesh& dense, int vertex, double multiple);
  void AddEdges(const EdgeCollapse& collapse);
};
}

#endif
