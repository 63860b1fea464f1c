// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   TerrainBisection
 * @brief   bisects a terrain until its projected error is small enough for a view
 *
 * The faces are those of longest-edge bisection on the lattice of samples (P. Lindstrom and V.
 * Pascucci, "Terrain simplification simplified", IEEE TVCG 8(3), 2002): the squares of blocks are
 * split at their centres, then pairs of triangles at the midpoints of the edges of squares. All
 * faces are drawn with the same pattern, so that neighbours share their edges without hanging
 * vertices. See BlockErrors for blocks and their errors.
 *
 * A bisection is a function of the view and of the tiles in memory alone. It begins when the
 * projected error before it reaches the tolerance and is complete when that error reaches 2^(1/8)
 * of the tolerance; between, heights are linear in the error, so that the error that is left stays
 * within the tolerance. As errors are saturated and
 * projected from regions that contain all finer ones, coarser bisections are complete before finer
 * ones begin.
 *
 * Tiles that are missing or not fully visible limit the errors of the bisections that need them.
 * These limit finer errors in turn, so that the order of bisections remains, and the surface is a
 * continuous function of view and visibility.
 *
 * Private to the modules for terrains.
 */
#ifndef TerrainBisection_h
#define TerrainBisection_h

#include "Bisection/HeightTileSource.h"
#include "Bisection/HiddenBlock.h"
#include "Bisection/TerrainFace.h"
#include "Bisection/TerrainShare.h"
#include "Bisection/TerrainView.h"
#include "Lattice/BlockErrors.h"
#include "Lattice/ElevationRanges.h"
#include "RelevoFiltersTerrainModule.h" // for export macro

#include <array>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

namespace relevo
{
class RELEVOFILTERSTERRAIN_EXPORT TerrainBisection
{
public:
  /// The size of the raster in samples. A raster with a period continues with its first column
  /// after this number of columns.
  TerrainBisection(int columns, int rows, const BlockErrors& errors, const ElevationRanges& ranges,
    int period = 0);

  /// Also find the faces above visible parts of a solid, whose bottom has this height.
  void SetBase(const std::optional<double>& height) { this->Base = height; }

  /// Find only the faces of a share. They are the same as without it, if all tiles are in memory.
  void SetShare(const std::optional<TerrainShare>& share) { this->Share = share; }

  /**
   * Find the faces that a view needs for a tolerance in pixels. Tiles that are not in memory are
   * requested; without the first two there are no faces.
   */
  void Select(const TerrainView& view, double tolerance, HeightTileSource& tiles);

  const std::vector<TerrainFace>& GetFaces() const { return this->Faces; }
  /// The blocks out of sight or of the share, which have no faces.
  const std::vector<HiddenBlock>& GetHiddenBlocks() const { return this->HiddenBlocks; }
  /// The largest projected error of the faces, in pixels.
  double GetError() const { return this->Error; }
  /// Whether the selection was stopped because the view needs more faces than MaximumFaces. Part of
  /// the terrain has no faces then.
  bool HasTooManyFaces() const;
  static constexpr std::size_t MaximumFaces = std::size_t(1) << 18;

  /// Whether tiles are missing or not fully visible yet, so that the error may exceed the
  /// tolerance.
  bool IsComplete() const { return this->Complete; }

private:
  struct Block
  {
    int Level;
    std::int64_t Column;
    std::int64_t Row;
  };
  // The sides of a block are its first row, last column, last row and first column.

  bool Exists(const Block& block) const;
  TerrainBox GetRegion(
    int level, const std::array<double, 2>& columns, const std::array<double, 2>& rows) const;
  double ProjectSquare(const Block& block);
  float GetEdgeError(const Block& block, int side) const;
  double ProjectEdge(const Block& block, int side);
  float Ramp(double error) const;
  double LimitSquare(const Block& block);
  double LimitEdge(const Block& block, int side);
  float GetSquareMorph(const Block& block);
  float GetEdgeMorph(const Block& block, int side);
  const HeightTile* FindTile(int level, const Block& block, double error, float& visibility);
  const HeightTile& GetTile(int level, const Block& block);
  bool IsVisible(const Block& block) const;
  bool IsShared(const Block& block) const;
  void Visit(const Block& block);
  void AddFace(const Block& block, int side, int end, float morph, double error);
  double ProjectFace(const Block& block, int side, int end, const TerrainFace& face) const;
  float GetCornerHeight(std::int64_t x, std::int64_t y);
  float ComputeCornerHeight(std::int64_t x, std::int64_t y);

  int Columns;
  int Rows;
  int Period;
  int RootLevel;
  const BlockErrors& Errors;
  const ElevationRanges& Ranges;
  std::optional<double> Base;
  std::optional<TerrainShare> Share;

  const TerrainView* View = nullptr;
  double Tolerance = 1.0;
  HeightTileSource* Tiles = nullptr;
  std::unordered_map<std::uint64_t, double> SquareErrors;
  std::unordered_map<std::uint64_t, double> EdgeErrors;
  std::unordered_map<std::uint64_t, float> Corners;
  std::vector<TerrainFace> Faces;
  std::vector<HiddenBlock> HiddenBlocks;
  double Error = 0.0;
  bool Complete = true;
};
}

#endif
