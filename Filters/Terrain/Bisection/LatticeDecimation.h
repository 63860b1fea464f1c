// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   LatticeDecimation
 * @brief   triangles within a vertical tolerance of a grid
 *
 * The surface of the grid is bilinear in each cell. A triangle is bisected if its largest vertical
 * distance from this surface exceeds the tolerance, or if its neighbour is bisected at their common
 * side (right-triangulated irregular networks: W. Evans, D. Kirkpatrick and G. Townsend,
 * Algorithmica 30(2), 2001). Cells are bisected, too, if the tolerance is small. Then
 * LatticeCollapse removes vertices.
 *
 * Cells with a vertex without data are left out; triangles at their outline are as small as cells.
 *
 * A shape error is added to the distance of each triangle, for grids that lie on curved surfaces.
 * No vertices are removed then.
 *
 * Private to the modules for terrains.
 */
#ifndef LatticeDecimation_h
#define LatticeDecimation_h

#include "RelevoFiltersTerrainModule.h" // for export macro

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <unordered_set>
#include <utility>
#include <vector>

namespace relevo
{
class RELEVOFILTERSTERRAIN_EXPORT LatticeDecimation
{
public:
  /// The heights of the vertices, row by row; at least 2 columns and rows.
  LatticeDecimation(std::vector<float> heights, int columns, int rows);

  /// The first and last column and row of a triangle, in cells.
  using Bounds = std::array<std::array<double, 2>, 2>;
  using ShapeError = std::function<double(const Bounds&)>;
  /// Set the shape error of triangles, and the largest of a cell. For a triangle of half the size,
  /// it is at most a quarter.
  void SetShapeError(ShapeError error, double ofCell)
  {
    this->FindShapeError = std::move(error);
    this->ShapeErrorOfCell = ofCell;
  }

  enum class Result
  {
    Done,
    Aborted,         // `isAborted` has returned true
    TooManyTriangles // more than MaximumTriangles, or cells would be too small
  };
  static constexpr std::size_t MaximumTriangles = std::size_t(1) << 26;

  /// Find the triangles. `isAborted` can ask for GetProgress().
  Result Refine(double tolerance, const std::function<bool()>& isAborted);

  /// Column and row in units of a cell divided by 2^GetSubdivisions().
  using Vertex = std::array<std::int64_t, 2>;
  using Triangle = std::array<Vertex, 3>;
  /// The triangles. Some reach beyond the last column or row.
  const std::vector<Triangle>& GetTriangles() const { return this->Triangles; }
  int GetSubdivisions() const { return this->Subdivisions; }

  /// The largest distance of a triangle, at most, with its shape error.
  double GetError() const { return this->Error; }

  /// The share of the grid that has been refined, from 0 to 1.
  double GetProgress() const { return this->Progress; }

  /// The largest |h00 + h11 - h01 - h10| of all cells with data.
  double GetLargestTwist() const;

  /// The height of the surface at a vertex; beyond the grid, that of its border.
  double GetHeight(const Vertex& vertex) const;

private:
  enum class Content
  {
    Surface, // data everywhere
    Mixed,
    Nothing // no data, or beyond the grid
  };

  double GetTwist(int column, int row) const;
  bool ChooseSubdivisions();
  double MeasureInCell(const Triangle& triangle, Content& content) const;
  double GetTwistOfSide(
    const Triangle& triangle, int side, std::int64_t column, std::int64_t row) const;
  double MeasureHeights(const Triangle& triangle, Content& content) const;
  double GetShapeError(const Triangle& triangle) const;
  double Measure(const Triangle& triangle, Content& content) const;
  void CountProgress(const Triangle& triangle);
  void Visit(const Triangle& triangle);
  bool IsMarked(const Vertex& vertex) const;
  void Mark(const Vertex& vertex);
  void Collect(const Triangle& triangle);

  std::vector<float> Heights;
  int Columns;
  int Rows;
  int Subdivisions = 0;
  double Tolerance = 0.0;
  ShapeError FindShapeError;
  double ShapeErrorOfCell = 0.0;
  double Error = 0.0;
  double Progress = 0.0;
  const std::function<bool()>* IsAborted = nullptr;
  Result State = Result::Done;
  bool HasChanged = false;
  std::int64_t Size = 1;                      // of the square that covers the grid
  std::unordered_set<std::uint64_t> Marked;   // midpoints of longest sides that are bisected
  std::unordered_set<std::uint64_t> Accepted; // triangles within the tolerance
  std::vector<Triangle> Triangles;
};
}

#endif
