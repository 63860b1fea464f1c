// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   PixelScale
 * @brief   largest number of pixels that a length of the mesh covers within the viewport
 *
 * Let z be the depth along the viewing direction, and t the tangent of the angle from this
 * direction. A length covers at most sqrt(1 + t^2) / z times its number of pixels at depth 1.
 */
#ifndef PixelScale_h
#define PixelScale_h

#include "RelevoFiltersCoreModule.h" // for export macro
#include "View/WorldView.h"

#include <string> // for errors

namespace relevo
{
/// A box of points in mesh coordinates.
struct PointBox
{
  dvec3 Low{ 0.0 };
  dvec3 High{ 0.0 };
};

class RELEVOFILTERSCORE_EXPORT PixelScale
{
public:
  explicit PixelScale(const RefinementView& view);

  /// Returns false with an `error` if the view is invalid. Other functions must not be called then.
  bool Check(const RefinementView& view, std::string& error);

  /// Returns the pixels of a unit of the mesh within a box, or infinity if the eye is inside of the
  /// box.
  double GetPixels(const PointBox& box) const;

  /// Returns the largest scale factor from mesh to world coordinates. Needs no Check().
  double GetMaximumStretch() const { return this->MaximumStretch; }

private:
  double GetDistance(const PointBox& box) const;

  Placement ToWorld;
  Eye View;
  double Pixels = 0.0;  // pixels of a world unit at distance 1, in parallel projection at any
                        // distance
  double Tangent = 0.0; // largest in the viewport
  double MinimumStretch = 0.0;
  double MaximumStretch = 0.0; // largest scale factor of the placement
  dvec3 MeshEye{ 0.0 };
};
}

#endif
