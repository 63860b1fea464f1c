// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   TileCaster
 * @brief   the colours of the pixels of a tile
 *
 * Private to the module.
 */
#ifndef TileCaster_h
#define TileCaster_h

#include "Cells/CellCrossing.h"
#include "Rays/Blending.h"
#include "Rays/ClippingPlanes.h"
#include "Rays/PixelRays.h"
#include "Tiles/CellOutline.h"
#include "Tiles/PixelCells.h"
#include "Tiles/ScalarTile.h"

#include <memory>
#include <vector>

namespace relevo
{
/// The cells, rays and settings that all tiles of an image share.
struct TileScene
{
  const CellCrossing& Crossing;
  const PixelCells& Pixels;
  const PixelRays& Rays;
  const ClippingPlanes& Planes;
  const Blending& Blend;
};

/// Each thread has its own object.
class TileCaster
{
public:
  /// Returns the colours of the pixels of a tile, in rows, until the next call. The scene must be
  /// the same in all calls.
  const std::vector<dvec4>& Cast(const TileScene& scene, int tile);

private:
  void CastParts(const TileScene& scene, int tile);

  std::vector<Ray> Rays;
  std::vector<dvec4> Colors;
  std::shared_ptr<ScalarTile> Scalars; // empty if colours do not depend on one scalar
  CellOutline Outline;
  std::vector<std::vector<int>> Candidates; // of each pixel
};
}

#endif
