// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   DisplacedSurface
 * @brief   the displaced surface of a coarse mesh, for metrics
 *
 * RefinementView refers to it if a height map displaces the mesh.
 */
#ifndef DisplacedSurface_h
#define DisplacedSurface_h

#include "Metrics/DiscreteCurvature.h" // for return value

class vtkPolyData;

namespace relevo
{
class Dependencies;
struct GlobalSurfaceInfo;

class DisplacedSurface
{
public:
  virtual ~DisplacedSurface() = default;

  /// Add the dependencies of the surface, without the mesh.
  virtual void AddTo(Dependencies& dependencies) const = 0;

  /**
   * Compute the curvature at the points of a mesh, including ghost cells. `whole` is the surface
   * that the mesh is a piece of, or nullptr. All values are 0 if the mesh cannot be displaced.
   */
  virtual DiscreteCurvature ComputeCurvature(
    vtkPolyData* mesh, const GlobalSurfaceInfo* whole) const = 0;
};
}

#endif
