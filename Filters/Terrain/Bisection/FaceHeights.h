// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   FaceHeights
 * @brief   the heights of the vertices of a terrain face
 *
 * The heights before a bisection are those of the parent's surface: its own vertices, and halfway
 * between two of them, along Step1 or Step2, for vertices that the bisection adds. Vertices on an
 * edge that another bisection will split keep the coarser heights, so that both faces of an edge
 * agree to the bit. The vertex shader of the mapper computes the same.
 *
 * A height is NaN where the data are missing.
 *
 * Private to the modules for terrains.
 */
#ifndef FaceHeights_h
#define FaceHeights_h

#include "Bisection/TerrainFace.h"
#include "RelevoFiltersTerrainModule.h" // for export macro

namespace relevo
{
class RELEVOFILTERSTERRAIN_EXPORT FaceHeights
{
public:
  explicit FaceHeights(const TerrainFace& face);

  /// The height of vertex (a, b) of the pattern.
  float GetHeight(int a, int b) const;

  /// A vertex that the bisection adds, as long as it moves. Its height before is the mean of the
  /// heights of (a - a % 2, b - b % 2) and (a + a % 2, b + b % 2).
  struct AddedVertex
  {
    float Sources[2];
    float Target;
  };
  /// Returns false if (a, b) is no such vertex.
  bool FindAdded(int a, int b, AddedVertex& added) const;

private:
  float GetFine(int a, int b) const;
  float GetCoarse(int a, int b) const;
  float GetSource(int a, int b) const;

  const TerrainFace& Face;
};

/// The height of the bilinear surface of a tile at a vertex of the lattice of a level, which is
/// that of the tile or, for tiles of level 0, finer.
RELEVOFILTERSTERRAIN_EXPORT float GetLatticeHeight(
  const HeightTile& tile, int level, std::int64_t x, std::int64_t y);
}

#endif
