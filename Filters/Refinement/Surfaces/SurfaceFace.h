// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @struct  relevo::SurfaceFace
 * @brief   one coarse triangle, passed to the functions of a surface
 *
 * @sa vtkRefinementSurface
 */
#ifndef SurfaceFace_h
#define SurfaceFace_h

#include <vector> // for tables

namespace relevo
{
/// Data of a mesh that all its faces can look up.
struct SurfaceTables
{
  /// Four numbers per point: a position and one value.
  std::vector<float> Points;
  /// Four numbers per record.
  std::vector<int> Records;
  /// The first record of each cell. All cells of the mesh are triangles.
  std::vector<int> Entries;
};

/// An end of an edge. Values are the values per point, or nullptr if there are none.
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
  /// The origin that points are relative to, in the mesh's coordinates.
  const double* Origin;
  /// Unit normals that all faces at a corner share. They are the corner's normals where normals are
  /// not split.
  const float* Directions[3];
  /// The values per point of each corner.
  const float* Values[3];
  /// The vectors of the edges (0,1), (1,2), (0,2), each from the first corner to the second:
  /// positions, then normals. The positions and then the normals of the face follow.
  const float* Vectors;
  /// The tables of the mesh, the first record of the face, and the code of the permutation from the
  /// cell's corners to the sorted corners (relevoWeights.glsl).
  const SurfaceTables* MeshTables;
  int TableEntry;
  int CornerOrder;
};
}

#endif
