// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   DrapedSurface
 * @brief   the surface of a terrain, which consists of patches
 *
 * Private to the modules for terrains.
 */
#ifndef DrapedSurface_h
#define DrapedSurface_h

#include "Draping/TerrainPatch.h"

#include <functional>

namespace relevo
{
class DrapedSurface
{
public:
  virtual ~DrapedSurface() = default;

  /// Visit the patches that overlap a rectangle and, if it is given, a segment, until the visitor
  /// returns false. A patch is valid during the call of the visitor.
  using Visitor = std::function<bool(const TerrainPatch&)>;
  virtual void Visit(const MapBox& box, const MapSegment* segment, const Visitor& visitor) = 0;
  /// The rectangle between the outermost samples of the raster.
  virtual MapBox GetBox() const = 0;
};
}

#endif
