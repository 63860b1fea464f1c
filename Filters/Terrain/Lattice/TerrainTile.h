// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @struct  TerrainTile
 * @brief   a tile of a lattice of samples of a raster: its position and size
 *
 * The lattice of level m has a vertex at every 2^m-th sample of the raster in both directions, from
 * the first column and row on. Tile (c, r) covers CellsPerTile x CellsPerTile cells of the lattice,
 * from vertex CellsPerTile * (c, r) on. It stores the vertices of these cells and one more ring
 * around them.
 *
 * Private to the modules for terrains.
 */
#ifndef TerrainTile_h
#define TerrainTile_h

#include <cstddef> // for std::size_t
#include <cstdint>

namespace relevo
{
struct TerrainTile
{
  static constexpr int CellsPerTile = 256;
  static constexpr int Stride = CellsPerTile + 3; // vertices per row
  static constexpr std::size_t NumberOfVertices = std::size_t(Stride) * Stride;

  enum class Kind : std::uint8_t
  {
    Imagery,
    Heights
  };

  /// The range of levels of all kinds.
  static constexpr int FinestLevel = -12;
  static constexpr int CoarsestLevel = 20;

  int Level = 0; // of the lattice
  int Column = 0;
  int Row = 0;

  virtual ~TerrainTile() = default;
  virtual Kind GetKind() const = 0;
  /// The values of the vertices, 4 bytes each, row by row; nullptr before they are read.
  virtual const void* GetValues() const = 0;
  /// Free the memory of the values.
  virtual void Clear() = 0;
};

/// A number for each tile. Finer levels have smaller numbers, and imagery has smaller ones than
/// heights.
inline std::uint64_t GetTileKey(TerrainTile::Kind kind, int level, int column, int row)
{
  return static_cast<std::uint64_t>(kind) << 62 |
    static_cast<std::uint64_t>(level - TerrainTile::FinestLevel) << 56 |
    static_cast<std::uint64_t>(row) << 28 | static_cast<std::uint64_t>(column);
}

inline std::uint64_t GetTileKey(const TerrainTile& tile)
{
  return GetTileKey(tile.GetKind(), tile.Level, tile.Column, tile.Row);
}
}

#endif
