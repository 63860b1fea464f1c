// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   TerrainPatch
 * @brief   a piece of a terrain's surface on which lines, points and polygons are laid
 *
 * The surface is a function of column and row. It has holes where data are missing. Private to the
 * modules for terrains.
 */
#ifndef TerrainPatch_h
#define TerrainPatch_h

#include "Draping/MapBox.h"
#include "Draping/SurfacePoint.h"

#include <functional>
#include <vector>

namespace relevo
{
class TerrainPatch
{
public:
  /// A part of a segment along which the surface is straight, or is within the tolerance.
  struct Piece
  {
    double First; // parameters of the segment
    double Last;
    SurfacePoint FirstPoint;
    SurfacePoint LastPoint;
  };

  virtual ~TerrainPatch() = default;

  /// The rectangle that contains the patch. Triangles may exceed it and must be clipped by it.
  const MapBox& GetBox() const { return this->Box; }

  /// Add the pieces of a segment that lie on the patch.
  virtual void AddPieces(const MapSegment& segment, std::vector<Piece>& pieces) const = 0;
  /// Find the point at a position. Return false if the patch is not there.
  virtual bool FindPoint(const MapPosition& position, SurfacePoint& point) const = 0;
  /// Visit the triangles that overlap a rectangle, until the visitor returns false.
  using TriangleVisitor = std::function<bool(const SurfaceTriangle&)>;
  virtual void VisitTriangles(const MapBox& box, const TriangleVisitor& visitor) const = 0;

protected:
  MapBox Box;
};
}

#endif
