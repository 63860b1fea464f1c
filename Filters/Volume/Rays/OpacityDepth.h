// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   OpacityDepth
 * @brief   finds where the opacity along a ray passes a threshold
 *
 * Private to the modules.
 */
#ifndef OpacityDepth_h
#define OpacityDepth_h

#include "Integral/Ray.h"
#include "Rays/BlendMode.h"
#include "Rays/IsoSurfaces.h"
#include "RelevoFiltersVolumeModule.h" // for export macro

#include <vector>

namespace relevo
{
/// A position in a part of a ray.
struct RayPosition
{
  size_t Part;
  double Share; // fraction of the part, from its front
};

class RELEVOFILTERSVOLUME_EXPORT OpacityDepth
{
public:
  OpacityDepth(const TransferFunctions& functions, BlendMode mode, const IsoSurfaces& surfaces)
    : Functions(functions)
    , Mode(mode)
    , Surfaces(surfaces)
  {
  }

  /**
   * Finds the first position at which the opacity from the front reaches the threshold, in ]0, 1].
   * Maximum and minimum have the position of the extreme scalar, if its opacity reaches the
   * threshold; of independent components, the first one counts. Returns false if there is no such
   * position, and for averages.
   */
  bool Find(const std::vector<RayPart>& parts, double threshold, RayPosition& position) const;

private:
  bool FindAlong(const std::vector<RayPart>& parts, double threshold, RayPosition& position) const;
  bool FindExtreme(
    const std::vector<RayPart>& parts, double threshold, RayPosition& position) const;
  double Add(double alpha, const Segment& segment) const;

  const TransferFunctions& Functions;
  const BlendMode Mode;
  const IsoSurfaces& Surfaces;
};
}

#endif
