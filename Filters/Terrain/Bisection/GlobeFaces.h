// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   GlobeFaces
 * @brief   the positions of the vertices of terrain faces in the geocentric frame
 *
 * Positions depend on the vertices of the lattice alone. They are cached from frame to frame.
 *
 * Private to the modules for terrains.
 */
#ifndef GlobeFaces_h
#define GlobeFaces_h

#include "Bisection/TerrainFace.h"
#include "Geodesy/TerrainPlacement.h"
#include "RelevoFiltersTerrainModule.h" // for export macro

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <unordered_map>
#include <vector>

namespace relevo
{
class RELEVOFILTERSTERRAIN_EXPORT GlobeFaces
{
public:
  static constexpr int VerticesPerFace =
    (TerrainFace::Segments + 1) * (TerrainFace::Segments + 2) / 2;

  /// The index of vertex (a, b) of the pattern.
  static constexpr int GetIndex(int a, int b)
  {
    return b * (2 * TerrainFace::Segments + 3 - b) / 2 + a;
  }

  using Vertices = std::array<GlobeShape::Vertex, VerticesPerFace>;

  /// The memory in bytes that the cache and the vertices of each face take at most. The cache also
  /// has SpareFaces.
  static constexpr std::size_t BytesPerFace = (sizeof(Vertices) + 64) * 5 / 4;
  static constexpr std::size_t SpareFaces = 64;

  /// Compute the vertices of faces that are not in the cache.
  void Update(const GlobeShape& shape, const std::vector<TerrainFace>& faces);

  /// The vertices of the faces of the last update.
  const std::vector<const Vertices*>& GetVertices() const { return this->Current; }
  /// The number of faces whose vertices were computed. As long as it is the same, a pointer of
  /// GetVertices() is that of the same vertices.
  std::uint64_t GetNumberOfComputedFaces() const { return this->Computed; }

  /**
   * The world coordinates of vertex (a, b). A vertex that a bisection adds moves from the midpoint
   * of an edge to its own position. NaN where the data are missing. The vertex shader of the mapper
   * computes the same relative to the eye.
   */
  static std::array<double, 3> GetWorld(const TerrainFace& face, const Vertices& vertices,
    const TerrainPlacement& placement, int a, int b);

  std::size_t GetMemorySize() const;
  void Clear();

private:
  struct Entry
  {
    std::unique_ptr<Vertices> Data;
    std::uint64_t LastUse = 0; // update
  };

  std::unordered_map<std::uint64_t, Entry> Entries;
  std::vector<const Vertices*> Current;
  std::uint64_t Updates = 0;
  std::uint64_t Computed = 0;
};
}

#endif
