// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   TerrainDivision
 * @brief   divides a terrain into shares with about the same number of faces in a view
 *
 * The number of faces is estimated from the errors of blocks, without tiles. The rectangle of the
 * raster is bisected across its longer side, as in a k-d tree, along borders of blocks.
 *
 * Private to the modules for terrains.
 */
#ifndef TerrainDivision_h
#define TerrainDivision_h

#include "Bisection/TerrainShare.h"
#include "Bisection/TerrainView.h"
#include "Lattice/BlockErrors.h"
#include "Lattice/ElevationRanges.h"
#include "RelevoFiltersTerrainModule.h" // for export macro

#include <array>
#include <cstddef>
#include <vector>

namespace relevo
{
class RELEVOFILTERSTERRAIN_EXPORT TerrainDivision
{
public:
  /// The size of the raster in samples.
  TerrainDivision(
    const std::array<int, 2>& dimensions, const BlockErrors& errors, const ElevationRanges& ranges);

  /// Return the shares of this number of processes, for a tolerance in pixels.
  std::vector<TerrainShare> Divide(const TerrainView& view, double tolerance, int number);

private:
  using Range = TerrainShare::Range;

  /// A block that is not split.
  struct Leaf
  {
    std::array<Range, 2> Sides; // columns and rows
    double Weight;              // in proportion to the number of its faces
  };
  using Leaves = std::vector<Leaf>;

  void FindLeaves(const TerrainView& view, double tolerance);
  static void Split(
    Leaves leaves, const TerrainShare& whole, int number, std::vector<TerrainShare>& shares);

  std::array<int, 2> Dimensions;
  const BlockErrors& Errors;
  const ElevationRanges& Ranges;
  Leaves Found;
};
}

#endif
