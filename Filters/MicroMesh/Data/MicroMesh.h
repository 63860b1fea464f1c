// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @struct  MicroMesh
 * @brief   a coarse mesh with a grid of displacements on each face
 *
 * A grid point is displaced by its sample, an integer, times the interpolated direction of the
 * corners. Corners are not displaced. The samples of an edge are stored once, so that both faces
 * read the same numbers. The level of an edge is not higher than those of its faces. Points of a
 * face's grid between the samples of an edge lie on the straight segments between these samples.
 * The surface consists of the triangles of the grids.
 */
#ifndef MicroMesh_h
#define MicroMesh_h

#include "Data/MicroGrid.h"
#include "Mathematics/RefinementMathematics.h"

#include <array>   // for members
#include <cstdint> // for samples
#include <vector>  // for members

namespace relevo
{
struct MicroMesh
{
  struct Edge
  {
    int First; // sample
    int Level;
  };
  struct Face
  {
    std::array<int, 3> Corners;
    /// The edge, times 2; plus 1 if its samples run from corner e + 1 to corner e.
    std::array<int, 3> Edges;
    int FirstInner; // sample
    int Level;
  };

  /// The position of a point of the grid of a face's level.
  dvec3 GetPosition(const Face& face, const GridPoint& point) const;
  /// All positions of the grid of a face's level, by GetGridIndex().
  std::vector<dvec3> GetPositions(const Face& face) const;
  /// The sample of a grid point that is not a corner, or -1 if it is between samples of an edge.
  int GetSampleIndex(const Face& face, const GridPoint& point) const;

  std::vector<dvec3> Points;
  /// The displacement of a sample of 1, per point.
  std::vector<vec3> Directions;
  std::vector<Edge> Edges;
  std::vector<Face> Faces;
  std::vector<std::int16_t> Samples;

private:
  dvec3 Displace(const Face& face, const dvec3& weights, int sample) const;
};
}

#endif
