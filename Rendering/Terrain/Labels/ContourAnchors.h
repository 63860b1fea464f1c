// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ContourAnchors
 * @brief   places on the contour lines of a terrain, for labels
 *
 * Each tile of the shading has at most one place per part, a square of some cells. It depends only
 * on the tile, so that it stays where it is while the camera moves. Contour lines are drawn from
 * the same tiles.
 *
 * Private to the module.
 */
#ifndef ContourAnchors_h
#define ContourAnchors_h

#include "Lattice/HeightTile.h"

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace relevo
{
class AdaptiveTerrain;
struct TerrainPlacement;

class ContourAnchors
{
public:
  struct Anchor
  {
    std::array<double, 2> Sample;   // column and row
    double Value = 0.0;             // of the contour line
    bool IsAlongRow = true;         // the direction in which the line was found
    int Level = 0;                  // of the tile
    std::array<double, 3> Position; // in coordinates of the actor
  };

  /// Forget all places, because the terrain, its frame or the interval has changed.
  void Clear() { this->Tiles.clear(); }

  /// Find the places in the tiles of the last frame. Return those that no finer tile covers.
  std::vector<Anchor> Find(const AdaptiveTerrain& terrain, double exaggeration, double interval);

  /// Move an anchor to the same line in the finest tile at its place. Return false if the line is
  /// not there.
  bool Update(const TerrainPlacement& placement, double interval, Anchor& anchor) const;

private:
  struct Part
  {
    const HeightTile* Tile = nullptr;
    std::vector<Anchor> Anchors;
  };

  const HeightTile* FindTile(const std::array<double, 2>& sample) const;

  std::unordered_map<std::uint64_t, Part> Tiles;
  std::array<int, 2> Levels = { { 0, 0 } }; // the finest and the coarsest
};
}

#endif
