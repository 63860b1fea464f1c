// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   relevo::SurfaceBounds
 * @brief   what a surface's face can reach, and the cone of its normals
 *
 * A part of vtkRefinementSurface; see GetReach() there. Culling, bounds and pickers rely on them.
 */
#ifndef SurfaceBounds_h
#define SurfaceBounds_h

#include "Surfaces/SurfaceFace.h"

namespace relevo
{
class SurfaceBounds
{
public:
  /**
   * Extend a box, relative to the origin, by all that the face may reach beyond its corners and
   * precomputed positions.
   */
  virtual void ExtendBox(const SurfaceFace&, double /*low*/[3], double /*high*/[3]) {}

  /**
   * A cone that holds the geometric normals of the whole face, those of (P1 - P0) x (P2 - P0):
   * fills its unit axis and returns the cosine of the angle between axis and side. 0, the default,
   * when nothing is known or the cone is no narrower than a half-space.
   */
  virtual float ComputeNormalCone(const SurfaceFace&, float axis[3])
  {
    axis[0] = axis[1] = axis[2] = 0.0f;
    return 0.0f;
  }

protected:
  SurfaceBounds() = default;
  ~SurfaceBounds() = default;
};
}

#endif
