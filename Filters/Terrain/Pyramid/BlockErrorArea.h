// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   BlockErrorArea
 * @brief   measures the errors of the blocks of some levels in an area of a raster
 *
 * The area consists of blocks of the level BaseLevel + NumberOfLevels; see BlockErrors. The
 * reference has the heights of the lattice of the base level. If that is level 0, the reference is
 * the surface of full resolution, and errors are exact except for the term of the twist of its
 * cells; see TriangleDistance. Otherwise the reference consists of the faces of the base level,
 * whose errors are added.
 *
 * A corner of a face can have the height of any finer lattice. The triangles at the corners are
 * measured with the lowest and with the highest of these heights; between, errors are less.
 *
 * A block in which some samples or vertices have data and others do not is given an error of at
 * least a quarter of the spacing of its lattice. The outline of missing data moves by up to that
 * spacing, which has no vertical distance; with this error it is drawn to a few pixels. Faces of
 * split squares of level 0 have the outline of the samples.
 *
 * Private to the module.
 */
#ifndef BlockErrorArea_h
#define BlockErrorArea_h

#include "Pyramid/TriangleDistance.h"
#include "Pyramid/ValueGrid.h"

#include <array>
#include <cstdint>

namespace relevo
{
class BlockErrorArea
{
public:
  static constexpr int NumberOfLevels = 7; // above the base level
  static constexpr int CellsPerArea = 8 << NumberOfLevels;

  /// The lowest and the highest height; NaN without data.
  using Range = std::array<float, 2>;

  /// Errors of the faces of a split square at its first row, last column, last row, first column.
  using Sides = std::array<float, 4>;

  // Whether samples and vertices of a block have data.
  static constexpr std::uint8_t HasData = 1;
  static constexpr std::uint8_t HasMissing = 2;

  struct Level
  {
    ValueGrid<float> Heights; // of the vertices of cells that have samples
    ValueGrid<Range> Corners; // of the blocks: the heights in lattices up to this level
    ValueGrid<std::uint8_t> Contents;
    ValueGrid<float> Bases;  // square errors without corners and outlines
    ValueGrid<float> Square; // at level 0 for 2 x 2 blocks together, for BlockErrors
    ValueGrid<Sides> Faces;  // of the sides of blocks; not used at level 0
  };

  /**
   * The first vertex of the base level, a multiple of CellsPerArea, and its number of vertices,
   * more than one per side.
   */
  BlockErrorArea(int baseLevel, int firstColumn, int firstRow, int width, int height);

  int GetBaseLevel() const { return this->BaseLevel; }
  //@{
  /// The first vertex, and the number of vertices, of the lattice of a level.
  std::array<int, 2> GetFirstVertex(int level) const;
  std::array<int, 2> GetNumberOfVertices(int level) const;
  //@}
  /// The number of blocks of a level.
  std::array<int, 2> GetNumberOfBlocks(int level) const;

  /// The heights of the base level in double precision, which the caller provides.
  ValueGrid<double>& GetReference() { return this->Reference; }

  /**
   * The results of a level. The caller provides the heights and, for a base level above 0, the
   * corners, contents and bases of that level.
   */
  Level& GetLevel(int level) { return this->Levels[level - this->BaseLevel]; }

  /// Take every second vertex of the finer lattice, for a lattice with the same heights.
  void ThinHeights(int level);

  /// Measure all levels up to the last. The distance of samples is in the unit of the heights.
  void Measure(int lastLevel, double sampleDistance);

private:
  struct Position
  {
    int Column;
    int Row;
  };

  void MeasureFullResolution(double sampleDistance);
  void MeasureLevel(int level, double sampleDistance);
  void MergeContents(int level);
  void MergeCorners(int level);
  TriangulatedGrid MakeSquares(int level) const;
  TriangulatedGrid MakeFaces(int level) const;
  ValueGrid<float> MeasureSquares(const TriangulatedGrid& grid, int level) const;
  ValueGrid<Sides> MeasureFaces(const TriangulatedGrid& grid, int level) const;
  float MeasureSquareCorners(const TriangulatedGrid& grid, int column, int row) const;
  void RaiseFaceCorners(const TriangulatedGrid& grid, int column, int row, Sides& sides) const;
  float MeasureCorner(const TriangulatedGrid& grid, const Range& range,
    const std::array<Position, 3>& vertices) const;

  int BaseLevel;
  std::array<int, 2> First;
  std::array<int, 2> Size;
  ValueGrid<double> Reference;
  std::array<Level, NumberOfLevels + 1> Levels;
};
}

#endif
