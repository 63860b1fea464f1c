// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   TriangleDistance
 * @brief   the vertical distance between surfaces of triangles and the surface that they
 * approximate
 *
 * The reference is a grid of heights. It is bilinear in its cells or, if `IsTriangulated` is set,
 * consists of two triangles per cell: those of unsplit squares of BlockErrors. Lengths are in cells
 * of the reference. Edges of the approximating triangles lie on its lines or on diagonals of its
 * cells. So in most cells the distance is largest at a corner. In cells on a diagonal, the twist of
 * the cell adds at most a quarter of it to the distances at the ends of the diagonal, or a half of
 * it at the centre if the reference has the other diagonal.
 *
 * Points where one of the surfaces is NaN do not count.
 *
 * Private to the module.
 */
#ifndef TriangleDistance_h
#define TriangleDistance_h

#include "Pyramid/ValueGrid.h"

#include <algorithm>
#include <array>
#include <vector>

namespace relevo
{
/// A surface with a vertex at every 2^Shift-th of the reference in both directions.
struct TriangulatedGrid
{
  int Shift = 0;
  int Width = 0; // in vertices; the last may lie beyond the reference
  int Height = 0;
  std::vector<double> Heights;
  /// The diagonal of a cell is the main one, from (0, 0) to (1, 1), if the sum of its column and
  /// row is even. The first cell is one of these of the raster.
  std::array<int, 2> FirstCell{ { 0, 0 } };

  bool IsMain(int column, int row) const
  {
    return ((column + this->FirstCell[0] + row + this->FirstCell[1]) & 1) == 0;
  }
};

class TriangleDistance
{
public:
  /// The reference has more than one height in both directions.
  explicit TriangleDistance(const ValueGrid<double>& reference)
    : Reference(reference)
  {
  }

  /// The reference consists of triangles, with the diagonals of an array of cells of the reference.
  void SetTriangulated(const std::array<int, 2>& firstCell);

  /**
   * The largest distance from a grid in blocks of 2^blockShift x 2^blockShift cells of the
   * reference; -1 in blocks without data.
   */
  ValueGrid<double> Measure(const TriangulatedGrid& grid, int blockShift) const;

  /// A value for each side of a block: its first row, last column, last row and first column.
  using Sides = std::array<double, 4>;
  /// The same in the four triangles between the centre of a block and its sides, whose edges are
  /// edges of the grid.
  ValueGrid<Sides> MeasureSides(const TriangulatedGrid& grid, int blockShift) const;

  /// Call a function with the sides of a block whose triangles contain a part of one of its size x
  /// size cells.
  template <typename Function>
  static void ForSides(int column, int row, int size, const Function& function)
  {
    const int border = std::min(row, size - 1 - row);
    if (column <= border)
    {
      function(3);
    }
    if (column >= size - 1 - border)
    {
      function(1);
    }
    if (column >= border && column <= size - 1 - border)
    {
      function(2 * row < size ? 0 : 2);
    }
  }

  struct Vertex
  {
    int Column;
    int Row;
    double Height;
  };
  static constexpr int MaximumSide = 128;
  /**
   * The largest distance from one triangle that extends over at most MaximumSide rows and columns;
   * -1 without data. Offsets, if there are any, are for 8 x 8 cells each and are added to the
   * distances in these.
   */
  double Measure(const std::array<Vertex, 3>& triangle, const ValueGrid<float>& offsets) const;

private:
  void MeasureRow(const TriangulatedGrid& grid, int row, double* largest) const;
  void MeasureRowOfBlocks(
    const std::vector<double>& line, int row, int blockShift, ValueGrid<Sides>& result) const;
  void MeasureDiagonals(
    const TriangulatedGrid& grid, int row, int blockShift, double* largest) const;
  double GetDiagonalDistance(bool isMain, int column, int row, double first, double second) const;

  const ValueGrid<double>& Reference;
  bool IsTriangulated = false;
  TriangulatedGrid Diagonals; // of the reference
};
}

#endif
