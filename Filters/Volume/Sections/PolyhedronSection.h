// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   the section of a surface and a polyhedron: which edges it crosses, and in what order
 *
 * Private to the module.
 */
#ifndef PolyhedronSection_h
#define PolyhedronSection_h

#include <array>
#include <vector>

namespace relevo
{
/// The numbers of a polyhedron's corners around each face.
using PolyhedronFaces = std::vector<std::vector<int>>;

/// Where the surface crosses a face, from one crossed edge to another.
struct FaceSegment
{
  int Face;
  std::array<int, 2> Edges;
};

struct PolyhedronSection
{
  std::vector<std::array<int, 2>> Edges; // corners of each crossed edge, the smaller first
  std::vector<FaceSegment> Segments;
  std::vector<std::vector<int>> Polygons; // crossed edges in order
};

/// Crosses the surface where the values at the corners change between negative and not negative.
/// On a face that it crosses more than once, segments separate the negative corners, which is the
/// same choice in both polyhedra at a face. Faces that do not enclose a volume give no polygon.
PolyhedronSection CutPolyhedron(const PolyhedronFaces& faces, const std::vector<double>& values);
}

#endif
