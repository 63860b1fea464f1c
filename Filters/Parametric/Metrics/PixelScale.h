// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   PixelScale
 * @brief   how many pixels a length of a mesh takes at most, where it is within the viewport
 *
 * At a depth z along the direction of view, and at a tangent t of the angle between this direction
 * and that from the eye, a length is no longer on the screen than sqrt(1 + t^2) / z times the
 * pixels of a length at depth 1.
 *
 * Private to the module's own sources.
 */
#ifndef PixelScale_h
#define PixelScale_h

#include "View/WorldView.h"

#include <string> // for errors

namespace relevo
{
/// A box of control points, in the mesh's coordinates.
struct PointBox
{
  dvec3 Low{ 0.0 };
  dvec3 High{ 0.0 };
};

class PixelScale
{
public:
  explicit PixelScale(const RefinementView& view);

  /// False and sets error where the view cannot be used; then nothing may be asked.
  bool Check(const RefinementView& view, std::string& error);

  /// Of a unit of the mesh anywhere in a box; infinity where the eye is inside.
  double GetPixels(const PointBox& box) const;

private:
  double GetDistance(const PointBox& box) const;

  Placement ToWorld;
  Eye View;
  double Pixels = 0.0;  // of a unit of the world at a distance of 1; if parallel, anywhere
  double Tangent = 0.0; // the largest in the viewport
  double MinimumStretch = 0.0;
  double MaximumStretch = 0.0; // of lengths by the placement
  dvec3 MeshEye{ 0.0 };
};
}

#endif
