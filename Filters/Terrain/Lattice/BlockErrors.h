// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   BlockErrors
 * @brief   bounds of the vertical errors of a bisected terrain, block by block
 *
 * A block of level m has 8 x 8 cells of the height lattice of level m, from vertex 8 * (column,
 * row) on; see HeightTile. The square of a block can be drawn as 2 triangles: its square error
 * bounds their distance from the surface of full resolution. Or it is drawn as 4, one at each edge
 * of the block: the error of an edge bounds the distance of the two triangles at it, one in each of
 * two blocks. All are drawn with the pattern of 8 segments; see TerrainFace.
 *
 * The errors are saturated: a square error is at least 2^(1/8) times the errors of the four edges
 * of the block, and the error of an edge at least 2^(1/8) times the square errors of the four
 * blocks of the next finer level that touch half of it. So the coarser bisections that a bisection
 * depends on always have larger errors.
 *
 * Errors of levels from 1 on are stored as one byte each: a number of steps of 2^(1/8) below the
 * largest error, rounded up, so that the values stay bounds and stay saturated.
 *
 * At level 0 one error is stored for 2 x 2 blocks together. It bounds the square errors, and
 * EdgeShareOfLevel0 of it bounds the errors of edges. Triangles of finer levels lie within one
 * bilinear cell each, so that their errors are proportional to the area of a block. To be
 * saturated, errors up to level 0 are at least NeighborShareOfLevel0 of the stored ones in the
 * neighbourhood of a block.
 *
 * Private to the modules for terrains.
 */
#ifndef BlockErrors_h
#define BlockErrors_h

#include "RelevoFiltersTerrainModule.h" // for export macro

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace relevo
{
class RELEVOFILTERSTERRAIN_EXPORT BlockErrors
{
public:
  static constexpr int CellsPerBlock = 8;
  static constexpr int BlocksPerTile = 32; // per side, in storage
  static constexpr int LargestCode = 255;
  static constexpr int StepsPerOctave = 8;
  /// At least 1 / 4, which is exact, and saturated: between 2^(1/8) / 4 and 2^(-1/8).
  static constexpr float EdgeShareOfLevel0 = 0.28f;
  /// At least 2^(1/8) EdgeShareOfLevel0.
  static constexpr float NeighborShareOfLevel0 = 0.32420988f; // 2^(-13/8)
  static constexpr int StepsToNeighborOfLevel0 = -13;
  /**
   * The finest level of blocks: below the resolution of the raster. There, faces differ from a
   * bilinear cell by 2^-18 of the error at level 0, which is as small as the rounding errors of
   * heights. Vertices of this level are integers of 32 bits.
   */
  static constexpr int FinestLevel = -9;

  /// The level at which one block covers a raster.
  static int GetRootLevel(int columns, int rows);

  //@{
  /// The error in the unit of the heights; 0 for blocks without a record.
  float GetSquareError(int level, int column, int row) const;
  /// Axis 0: the edge along the first row of a block. Axis 1: along its first column. The block may
  /// be one beyond the last.
  float GetEdgeError(int level, int column, int row, int axis) const;
  //@}

  /// The values of one kind for BlocksPerTile x BlocksPerTile blocks, row by row.
  template <typename T>
  using Values = std::array<T, BlocksPerTile * BlocksPerTile>;
  /// The kinds of errors: RowEdge + axis for edges, which are not stored at level 0.
  enum Kind : int
  {
    Square,
    RowEdge,
    ColumnEdge
  };
  static constexpr int NumberOfKinds = 3;
  using Tile = std::array<Values<std::uint8_t>, NumberOfKinds>; // codes
  using Tiles = std::unordered_map<std::uint64_t, Tile>;        // by MakeGridKey()

  /// Errors that are 0 everywhere, on levels from 0 to a root level.
  explicit BlockErrors(int rootLevel = 0);

  /// Errors that are not known, for a raster without an index: proportional to the size of a block,
  /// and to its area below level 0.
  static BlockErrors Estimate(int rootLevel, float squareErrorOfLevel0);

  //@{
  /// The largest error, which has the code 255, and the codes of a level. Those of level 0 are for
  /// 2 x 2 blocks each.
  float GetLargest() const { return this->Largest; }
  void SetLargest(float error) { this->Largest = error; }
  int GetRootLevel() const { return static_cast<int>(this->Levels.size()) - 1; }
  Tiles& GetTiles(int level) { return this->Levels[level]; }
  const Tiles& GetTiles(int level) const { return this->Levels[level]; }
  //@}

private:
  float Find(int level, int column, int row, int kind) const;
  float FindSaturated(int level, int column, int row, int neighbors) const;

  std::vector<Tiles> Levels;
  float Largest = 0.0f;
  float Estimated = 0.0f; // the square error of level 0; 0 if errors are known
};
}

#endif
