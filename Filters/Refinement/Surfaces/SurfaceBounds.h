// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   relevo::SurfaceBounds
 * @brief   bounds of a face of a surface, and the cone of its normals
 *
 * Part of vtkRefinementSurface; see GetReach() there. Culling, bounding boxes and pickers use these
 * functions.
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
   * Extend a box, relative to the origin, to contain the whole face, which may reach beyond its
   * corners and precomputed positions.
   */
  virtual void ExtendBox(const SurfaceFace&, double /*low*/[3], double /*high*/[3]) {}

  /**
   * Compute a cone that contains the geometric normals of the whole face, those of (P1 - P0) x
   * (P2 - P0). Sets its unit axis and returns the cosine of the angle between the axis and the
   * side. Returns 0, the default, if the normals are not known or the cone is at least a
   * half-space.
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
