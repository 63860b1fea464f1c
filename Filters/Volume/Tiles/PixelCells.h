// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   PixelCells
 * @brief   the cells that rays through the pixels of each tile of an image may cross
 *
 * Cells are projected to the image. What is in front of the near plane is clipped. Tiles are
 * squares of pixels, in rows from the bottom.
 *
 * Private to the module.
 */
#ifndef PixelCells_h
#define PixelCells_h

#include "Cells/VolumeCells.h"
#include "Tiles/CellOutline.h"

#include <algorithm> // for inline functions
#include <array>
#include <cmath> // for inline functions
#include <vector>

class vtkCamera;

namespace relevo
{
class PixelCells
{
public:
  static constexpr int TileSize = 16; // pixels

  /// `cells` must have been moved to the origin and must outlive this object. A cell's number is
  /// that of a RayPart.
  PixelCells(const VolumeCells& cells, vtkCamera* camera, int width, int height);

  struct Tile
  {
    int Left; // the pixels from Left to Right - 1
    int Right;
    int Bottom;
    int Top;

    /// Calls visit(index) for the pixels inside of an outline. Indices are in rows.
    template <typename Visitor>
    void Visit(const CellOutline& outline, const Visitor& visit) const;
  };
  int GetNumberOfTiles() const { return this->Columns * this->Rows; }
  Tile GetTile(int tile) const;

  /// Returns the cells of a tile, approximately from front to back.
  std::vector<int> FindCells(int tile) const;

  /// Computes the outline of a cell.
  void FindOutline(int cell, CellOutline& outline) const;

private:
  struct Point
  {
    dvec2 Pixel;
    double Depth; // less than 0 in front of the near plane
  };
  using PixelBox = std::array<int, 4>; // the first and last column and row; empty if invisible

  template <typename Add>
  void VisitHull(int cell, const Add& add) const;
  dvec4 Project(const dvec3& point) const;
  dvec2 FindPixel(const dvec4& clip) const;
  void FindPoints();
  PixelBox FindBox(int cell, CellOutline& outline) const;
  void FillTiles();
  double FindDepth(int cell) const;

  const VolumeCells& Cells;
  dmat4 ToClip; // from coordinates of the cells
  int Width;
  int Height;
  int Columns; // of tiles
  int Rows;
  double Margin; // pixels
  std::vector<Point> Points;
  std::vector<size_t> Firsts; // in Items, of each tile
  std::vector<int> Items;
};

template <typename Visitor>
void PixelCells::Tile::Visit(const CellOutline& outline, const Visitor& visit) const
{
  const auto clampToInt = [](double position, int low, int high)
  { return static_cast<int>(std::clamp<double>(position, low, high)); };
  const int bottom = clampToInt(std::ceil(outline.GetLow().y), this->Bottom, this->Top);
  const int top = clampToInt(std::floor(outline.GetHigh().y), this->Bottom - 1, this->Top - 1);
  for (int row = bottom; row <= top; ++row)
  {
    double first;
    double last;
    if (!outline.GetSpan(row, first, last))
    {
      continue;
    }
    const int begin = clampToInt(std::ceil(first), this->Left, this->Right);
    const int end = clampToInt(std::floor(last), this->Left - 1, this->Right - 1);
    const int firstOfRow = (row - this->Bottom) * (this->Right - this->Left) - this->Left;
    for (int column = begin; column <= end; ++column)
    {
      visit(static_cast<size_t>(firstOfRow + column));
    }
  }
}
}

#endif
