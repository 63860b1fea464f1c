// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   LatticePatch
 * @brief   cells of a height lattice between whose vertices the surface is bilinear
 *
 * Private to the modules for terrains.
 */
#ifndef LatticePatch_h
#define LatticePatch_h

#include "Draping/TerrainPatch.h"
#include "Geodesy/TerrainPlacement.h"
#include "Lattice/HeightTile.h"
#include "RelevoFiltersTerrainModule.h" // for export macro

#include <array>
#include <cstdint>

namespace relevo
{
class RELEVOFILTERSTERRAIN_EXPORT LatticePatch : public TerrainPatch
{
public:
  /// The part of a tile in a box, which may cut cells. The tile and the placement must outlive the
  /// patch. Pieces and triangles are within a tolerance of the surface, in the unit of heights.
  LatticePatch(
    const HeightTile& tile, const TerrainPlacement& placement, const MapBox& box, double tolerance);

  void AddPieces(const MapSegment& segment, std::vector<Piece>& pieces) const override;
  bool FindPoint(const MapPosition& position, SurfacePoint& point) const override;
  void VisitTriangles(const MapBox& box, const TriangleVisitor& visitor) const override;

private:
  // The heights at the corners of a cell: (0, 0), (1, 0), (0, 1) and (1, 1).
  struct Cell
  {
    std::array<std::int64_t, 2> First;
    std::array<double, 4> Heights;
    double GetTwist() const
    {
      return this->Heights[0] - this->Heights[1] - this->Heights[2] + this->Heights[3];
    }
  };

  MapPosition ToLattice(const MapPosition& position) const;
  bool GetCell(const std::array<std::int64_t, 2>& first, Cell& cell) const;
  bool FindCell(const MapPosition& inLattice, Cell& cell) const;
  SurfaceVertex GetVertex(const Cell& cell, const MapPosition& inLattice) const;
  SurfacePoint GetPoint(const Cell& cell, const MapPosition& position) const;
  int CountParts(double largestDistance) const;
  bool VisitCell(const Cell& cell, const TriangleVisitor& visitor) const;

  const HeightTile& Tile;
  const TerrainPlacement& Placement;
  std::array<std::int64_t, 2> FirstVertex;
  std::array<std::int64_t, 2> LastVertex;
  double Tolerance;
  double Size; // of a cell, in samples
};
}

#endif
