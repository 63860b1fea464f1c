// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   RasterSurface
 * @brief   the surface of a raster at full resolution, bilinear between the centres of samples
 *
 * Private to the modules for terrains.
 */
#ifndef RasterSurface_h
#define RasterSurface_h

#include "Draping/DrapedSurface.h"
#include "Draping/LatticePatch.h"
#include "Geodesy/TerrainPlacement.h"
#include "Lattice/HeightTile.h"
#include "RelevoFiltersTerrainModule.h" // for export macro

#include <cstdint>
#include <memory>
#include <string>
#include <unordered_map>

namespace relevo
{
class HeightLattice;

class RELEVOFILTERSTERRAIN_EXPORT RasterSurface : public DrapedSurface
{
public:
  /// The lattice must outlive the surface. The tolerance is that of LatticePatch.
  RasterSurface(const HeightLattice& lattice, const TerrainPlacement& placement, double tolerance);
  ~RasterSurface() override;

  void Visit(const MapBox& box, const MapSegment* segment, const Visitor& visitor) override;
  MapBox GetBox() const override { return { { { 0.0, 0.0 } }, this->LastSample }; }

  /// The first error of a tile, which is a hole, or "".
  const std::string& GetError() const { return this->Error; }

private:
  struct Entry
  {
    HeightTile Tile;
    std::unique_ptr<LatticePatch> Patch; // nullptr if the tile cannot be read
  };
  const LatticePatch* GetPatch(int column, int row);

  const HeightLattice& Lattice;
  TerrainPlacement Placement;
  double Tolerance;
  MapPosition LastSample;
  std::unordered_map<std::uint64_t, Entry> Entries;
  std::string Error;
};
}

#endif
