// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @struct  TerrainFace
 * @brief   a triangle of a bisected terrain that is drawn with a pattern of 64 triangles
 *
 * A face is a right isosceles triangle on the height lattice of level Level, with the right angle
 * at its apex. Vertex (a, b) of its pattern, a + b <= Segments, is the vertex
 * Apex + a * Step1 + b * Step2 of that lattice, which has a vertex at every 2^Level-th sample of
 * the raster (Level may be negative). FaceHeights computes the heights. The triangles of the
 * pattern are those of six bisections of the face, too, so that all triangles of the terrain are
 * nested.
 *
 * Private to the modules for terrains.
 */
#ifndef TerrainFace_h
#define TerrainFace_h

#include "Lattice/HeightTile.h"
#include "RelevoFiltersTerrainModule.h" // for export macro

#include <array>
#include <cmath>
#include <cstdint>

namespace relevo
{
struct RELEVOFILTERSTERRAIN_EXPORT TerrainFace
{
  static constexpr int Segments = 8; // per leg and on the longest side

  /// The vertices (a, b) of the triangles of the pattern. Each triangle turns as the face does,
  /// from its first axis to the second.
  using PatternTriangle = std::array<std::array<int, 2>, 3>;
  static const std::array<PatternTriangle, Segments * Segments>& GetPattern();

  /// Which bisection has made the face.
  enum class Origin : std::uint8_t
  {
    Square, ///< of a square along both diagonals: the legs are halves of the diagonals
    Edge    ///< of two triangles across an edge of squares: the legs are parallel to the axes
  };

  int Level = 0;
  Origin Made = Origin::Square;
  std::array<std::int64_t, 2> Apex = { { 0, 0 } };
  std::array<int, 2> Step1 = { { 0, 0 } }; // to the corner (Segments, 0)
  std::array<int, 2> Step2 = { { 0, 0 } }; // to the corner (0, Segments)
  /// 0 for the surface before the bisection, 1 for the heights of this face, linear between.
  float Morph = 1.0f;
  /// The heights of the apex and of the corners (Segments, 0) and (0, Segments).
  std::array<float, 3> CornerHeights = { { 0.0f, 0.0f, 0.0f } };
  /// The tiles of levels max(Level, 0) and max(Level + 1, 0) that contain the face.
  const HeightTile* Tile = nullptr;
  const HeightTile* CoarseTile = nullptr;
  /// The projected error of this face in pixels, at most.
  float Error = 0.0f;

  /// The vertex (a, b) of the pattern, in the lattice of the face's level.
  std::array<std::int64_t, 2> GetVertex(int a, int b) const
  {
    return { { this->Apex[0] + a * this->Step1[0] + b * this->Step2[0],
      this->Apex[1] + a * this->Step1[1] + b * this->Step2[1] } };
  }
  /// Its column and row in samples.
  std::array<double, 2> GetSample(int a, int b) const
  {
    const std::array<std::int64_t, 2> vertex = this->GetVertex(a, b);
    const double size = std::ldexp(1.0, this->Level);
    return { { size * static_cast<double>(vertex[0]), size * static_cast<double>(vertex[1]) } };
  }

  /// Whether (Step1, Step2) turns from the raster's columns to its rows, as (1, 0) and (0, 1).
  bool IsPositive() const
  {
    return this->Step1[0] * this->Step2[1] - this->Step1[1] * this->Step2[0] > 0;
  }
};
}

#endif
