// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @struct  relevo::SurfaceFace
 * @brief   one coarse triangle, as a surface of your own sees it
 *
 * @sa vtkRefinementSurface
 */
#ifndef SurfaceFace_h
#define SurfaceFace_h

#include <vector> // for tables

namespace relevo
{
/// Numbers of a mesh, for all its faces to look up.
struct SurfaceTables
{
  /// Four per point: a position, and a number that belongs to it.
  std::vector<float> Points;
  /// Four per record.
  std::vector<int> Records;
  /// For each cell of the mesh, all of them triangles, the record that its face starts from.
  std::vector<int> Entries;
};

/// An end of an edge. Values are those per point; nullptr when there are none.
struct SurfaceCorner
{
  const float* Point;
  const float* Normal;
  const float* Values;
};

/// Corners are sorted by merged point.
struct SurfaceFace
{
  float Points[3][3];
  float Normals[3][3];
  /// Add it to points to get the mesh's own coordinates.
  const double* Origin;
  /// Unit normals that all faces around a corner share: its own where normals are not split.
  const float* Directions[3];
  /// The numbers per point of each corner.
  const float* Values[3];
  /// The vectors of edges (0,1), (1,2), (0,2), each from its first corner to its second:
  /// positions, then normals. Then the face's positions, then its normals.
  const float* Vectors;
  /// The mesh's tables, the face's first record, and the code of the permutation from the cell's
  /// own corners to these (relevoWeights.glsl).
  const SurfaceTables* MeshTables;
  int TableEntry;
  int CornerOrder;
};
}

#endif
