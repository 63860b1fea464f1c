// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   TerrainBorder
 * @brief   the triangles of a solid at the borders of a terrain and of its holes
 *
 * Faces reach beyond the last sample, because they are parts of blocks. Their triangles are clipped
 * here, so that their edges are those of the walls. Clipping depends on whole numbers alone: each
 * point is a weighted mean of vertices of one face, with the same weights in all triangles that
 * share it. The vertex shader computes its position.
 *
 * A wall stands below each edge that no other triangle has, except where the neighbour is a face
 * without borders or out of sight. Private to the module.
 */
#ifndef TerrainBorder_h
#define TerrainBorder_h

#include "Bisection/GlobeFaces.h"
#include "Bisection/TerrainFace.h"
#include "Buffers/TerrainPatterns.h"

#include <array>
#include <cstdint>
#include <limits>
#include <unordered_map>
#include <utility>
#include <vector>

namespace relevo
{
class TerrainBorder
{
public:
  static constexpr std::int64_t NoBorder = std::numeric_limits<std::int64_t>::max();

  struct Settings
  {
    /// Whether the first column and row are borders.
    std::array<bool, 2> HasFirst = { { true, true } };
    /// The last column and row in units of the finest lattice; NoBorder if there is none.
    std::array<std::int64_t, 2> Last = { { NoBorder, NoBorder } };
    /// Whether triangles that turn from columns to rows face down.
    bool IsMirrored = false;
    /// The positions of the vertices of faces on a globe, or nullptr.
    const std::vector<const GlobeFaces::Vertices*>* Vertices = nullptr;
  };

  /// Find the borders of faces. Nothing is computed if the faces are the same. The orientation and
  /// the borders must not change before Clear().
  void Update(const std::vector<TerrainFace>& faces, const Settings& settings);
  void Clear();

  /// Return whether a face has borders or missing data, so that its triangles are those of
  /// Expand().
  const std::vector<bool>& GetAreAtBorder() const { return this->AreAtBorder; }

  /// The numbers of a vertex, see relevoTerrainSolidVS.glsl.
  static constexpr int NumbersPerVertex = 4;
  /// Return the vertices of the triangles, of their edges or of their points. The numbers of faces
  /// are replaced by `places`.
  std::vector<unsigned int> Expand(
    TerrainPatterns::Primitives primitives, const std::vector<unsigned int>& places) const;

  /// The side of a solid that faces down. Walls have a number for each direction.
  static constexpr int Bottom = 16;

private:
  using Point = std::array<std::int64_t, 2>; // in units of the finest lattice

  // A point of a face: its vertices and their weights.
  struct Mean
  {
    std::array<std::array<int, 2>, 3> Vertices;
    std::array<float, 2> Weights;
    int NumberOfVertices;
  };
  struct Corner
  {
    int Mean;
    bool IsAtBase;
  };
  struct Triangle
  {
    int Face;
    int Side; // 0 for the surface
    std::array<Corner, 3> Corners;
  };
  // A directed edge of the surface.
  struct Edge
  {
    int Face;
    std::array<int, 2> Means;
    std::array<Point, 2> Points;
  };
  using SideKey = std::array<std::uint64_t, 2>; // the ends of an edge or of a side of a face
  struct HashSide
  {
    std::size_t operator()(const SideKey& key) const
    {
      return static_cast<std::size_t>(
        (key[0] * 0x9e3779b97f4a7c15u ^ key[1]) * 0xc2b2ae3d27d4eb4fu >> 7);
    }
  };

  void FindFaces(const std::vector<TerrainFace>& faces);
  void AddFace(const std::vector<TerrainFace>& faces, int face, const std::vector<bool>& missing);
  void AddTriangle(const TerrainFace& face, int index, const TerrainFace::PatternTriangle& triangle,
    std::vector<Edge>& edges);
  int AddMean(
    const TerrainFace& face, const TerrainFace::PatternTriangle& triangle, const Point& point);
  void AddWall(const Edge& edge);
  void AddOpenSides();
  bool IsOnBorder(const Edge& edge, bool& hasWall) const;

  Settings Current;
  std::vector<TerrainFace> Faces; // of the last update
  std::vector<bool> AreAtBorder;
  std::vector<std::vector<bool>> Missing;                   // of faces at borders
  std::unordered_map<SideKey, int, HashSide> SidesAtBorder; // and how many faces have them
  std::vector<Edge> OpenEdges;                              // on sides of faces
  std::unordered_map<std::uint64_t, int> MeansOfFace;
  std::vector<Mean> Means;
  std::vector<Triangle> Triangles;
};
}

#endif
