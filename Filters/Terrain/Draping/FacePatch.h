// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   FacePatch
 * @brief   the triangles of a terrain face that is drawn
 *
 * Private to the modules for terrains.
 */
#ifndef FacePatch_h
#define FacePatch_h

#include "Bisection/GlobeFaces.h"
#include "Bisection/TerrainFace.h"
#include "Draping/TerrainPatch.h"
#include "Geodesy/TerrainPlacement.h"
#include "RelevoFiltersTerrainModule.h" // for export macro

namespace relevo
{
class RELEVOFILTERSTERRAIN_EXPORT FacePatch : public TerrainPatch
{
public:
  /// The arguments must outlive the patch. The vertices are those on a globe, nullptr on a map. The
  /// raster ends at the last column and row.
  FacePatch(const TerrainFace& face, const GlobeFaces::Vertices* vertices,
    const TerrainPlacement& placement, const MapPosition& lastSample);

  void AddPieces(const MapSegment& segment, std::vector<Piece>& pieces) const override;
  bool FindPoint(const MapPosition& position, SurfacePoint& point) const override;
  void VisitTriangles(const MapBox& box, const TriangleVisitor& visitor) const override;

private:
  using PatternVertex = std::array<int, 2>;

  MapPosition ToPattern(const MapPosition& position) const;
  SurfaceVertex GetVertex(const PatternVertex& vertex) const;
  bool GetTriangle(const std::array<PatternVertex, 3>& vertices, SurfaceTriangle& triangle) const;
  bool FindTriangle(const MapPosition& inPattern, SurfaceTriangle& triangle) const;

  const TerrainFace& Face;
  const GlobeFaces::Vertices* Vertices;
  const TerrainPlacement& Placement;
  MapPosition LastSample;
  double Size; // of a cell of the lattice, in samples
};
}

#endif
