// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   DrawnSurface
 * @brief   the surface of a terrain as it was drawn last, and coarsely where it is out of sight
 *
 * Before it is drawn, it is flat, at half of the range of heights.
 *
 * Private to the modules for terrains.
 */
#ifndef DrawnSurface_h
#define DrawnSurface_h

#include "Draping/DrapedSurface.h"
#include "Geodesy/TerrainPlacement.h"
#include "Lattice/HeightTile.h"
#include "RelevoFiltersTerrainModule.h" // for export macro

#include <cstddef>
#include <memory>
#include <vector>

namespace relevo
{
class AdaptiveTerrain;

class RELEVOFILTERSTERRAIN_EXPORT DrawnSurface : public DrapedSurface
{
public:
  /// The terrain must not select other faces while this object exists.
  DrawnSurface(const AdaptiveTerrain& terrain, double exaggeration);
  ~DrawnSurface() override;

  void Visit(const MapBox& box, const MapSegment* segment, const Visitor& visitor) override;
  MapBox GetBox() const override { return { { { 0.0, 0.0 } }, this->LastSample }; }

private:
  // A binary tree of patches. Leaves have one patch, others two children from First on.
  struct Node
  {
    MapBox Box;
    const TerrainPatch* Patch = nullptr;
    std::size_t First = 0;
  };
  using Patches = std::vector<std::unique_ptr<TerrainPatch>>;
  void MakeNode(std::size_t node, Patches::iterator begin, Patches::iterator end);

  void AddFlatPatch(const AdaptiveTerrain& terrain);

  TerrainPlacement Placement;
  MapPosition LastSample;
  HeightTile FlatTile;
  Patches Members;
  std::vector<Node> Nodes;
};
}

#endif
