// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   MipmapTiles
 * @brief   finds the tiles whose samples are about as large as the pixels of a view
 *
 * The lattices of a terrain are a mipmap of its raster. A fragment whose pixel covers 2^l x 2^l
 * samples needs the levels floor(l) and floor(l) + 1, for shading that shows all details, however
 * large the faces are. Tiles are chosen by the distance of their nearest point, which is a little
 * finer than most of their fragments need.
 *
 * Private to the modules for terrains.
 */
#ifndef MipmapTiles_h
#define MipmapTiles_h

#include "Bisection/HeightTileSource.h"
#include "Bisection/ImageryTileSource.h"
#include "Bisection/TerrainShare.h"
#include "Bisection/TerrainView.h"
#include "Lattice/ElevationRanges.h"
#include "Lattice/ImageryLattice.h"
#include "RelevoFiltersTerrainModule.h" // for export macro

#include <functional>
#include <optional>
#include <vector>

namespace relevo
{
class RELEVOFILTERSTERRAIN_EXPORT MipmapTiles
{
public:
  struct Item
  {
    const TerrainTile* Tile;
    float Visibility; // from 0 to 1
  };

  /// The size of the raster in samples.
  MipmapTiles(int columns, int rows, const ElevationRanges& ranges);

  /// Find only the tiles that faces of a share need.
  void SetShare(const std::optional<TerrainShare>& share) { this->Share = share; }

  /**
   * Find the tiles that a view needs. Tiles that are not in memory are requested, with errors below
   * `largestError`: coarse and near ones have the larger errors.
   */
  void Select(const TerrainView& view, double largestError, HeightTileSource& tiles);

  /**
   * The same for imagery, whose levels may be finer than the samples of the raster. There are no
   * tiles where the imagery covers nothing. The error of a tile is half of a texel of the next
   * coarser level: how far a colour may be from its position. That of the coarsest tile is
   * infinite.
   */
  void SelectImagery(
    const TerrainView& view, const ImageryLattice& imagery, ImageryTileSource& tiles);

  const std::vector<Item>& GetTiles() const { return this->Tiles; }
  /// Whether no tile is missing, and all are fully visible.
  bool IsComplete() const { return this->Complete; }

private:
  /// Returns a tile that is in memory, as HeightTileSource::Get().
  using Finder = std::function<const TerrainTile*(
    int level, int column, int row, double error, float& visibility)>;

  void Start(const TerrainView& view, double largestError);
  void Visit(int level, int column, int row, double pixels);

  int Columns;
  int Rows;
  const ElevationRanges& Ranges;
  std::optional<TerrainShare> Share;

  const TerrainView* View = nullptr;
  double LargestError = 0.0; // of heights
  const ImageryLattice* Imagery = nullptr;
  int FinestLevel = 0;
  Finder Find;
  std::vector<Item> Tiles;
  bool Complete = true;
};
}

#endif
