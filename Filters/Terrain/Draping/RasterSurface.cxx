// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Draping/RasterSurface.h"

#include "Lattice/HeightLattice.h"
#include "Raster/GridKey.h"

#include <algorithm>
#include <cmath>

namespace relevo
{
namespace
{
constexpr std::size_t MaximumTiles = 256; // 66 MiB
constexpr double TileSize = HeightTile::CellsPerTile;

MapBox GetTileBox(int column, int row)
{
  MapBox box;
  box.Add({ { column * TileSize, row * TileSize } });
  box.Add({ { (column + 1) * TileSize, (row + 1) * TileSize } });
  return box;
}
}

RasterSurface::RasterSurface(
  const HeightLattice& lattice, const TerrainPlacement& placement, double tolerance)
  : Lattice(lattice)
  , Placement(placement)
  , Tolerance(tolerance)
  , LastSample{ { lattice.Describe().Width - 1.0, lattice.Describe().Height - 1.0 } }
{
}

RasterSurface::~RasterSurface() = default;

const LatticePatch* RasterSurface::GetPatch(int column, int row)
{
  const std::uint64_t key = MakeGridKey(column, row);
  const auto known = this->Entries.find(key);
  if (known != this->Entries.end())
  {
    return known->second.Patch.get();
  }
  if (this->Entries.size() >= MaximumTiles)
  {
    this->Entries.clear();
  }
  Entry& entry = this->Entries[key];
  entry.Tile.Column = column;
  entry.Tile.Row = row;
  std::string error;
  if (!this->Lattice.Read(entry.Tile, error))
  {
    this->Error = this->Error.empty() ? error : this->Error;
    return nullptr;
  }
  MapBox box = GetTileBox(column, row);
  box.Clip(this->LastSample);
  entry.Patch = std::make_unique<LatticePatch>(entry.Tile, this->Placement, box, this->Tolerance);
  return entry.Patch.get();
}

void RasterSurface::Visit(const MapBox& box, const MapSegment* segment, const Visitor& visitor)
{
  int first[2];
  int last[2];
  for (int axis = 0; axis < 2; ++axis)
  {
    // Positions at the borders of the raster are inside of it in spite of rounding errors.
    const double low = box.Low[axis] - MapSegment::Tolerance;
    const double high = box.High[axis] + MapSegment::Tolerance;
    if (!(low <= this->LastSample[axis] && high >= 0.0))
    {
      return;
    }
    const double end = std::max(0.0, std::ceil(this->LastSample[axis] / TileSize) - 1.0);
    first[axis] = static_cast<int>(std::clamp(std::floor(low / TileSize), 0.0, end));
    last[axis] = static_cast<int>(std::clamp(std::floor(high / TileSize), 0.0, end));
  }
  for (int row = first[1]; row <= last[1]; ++row)
  {
    for (int column = first[0]; column <= last[0]; ++column)
    {
      const bool isMet = !segment || GetTileBox(column, row).Overlaps(*segment);
      const LatticePatch* patch = isMet ? this->GetPatch(column, row) : nullptr;
      if (patch && !visitor(*patch))
      {
        return;
      }
    }
  }
}
}
