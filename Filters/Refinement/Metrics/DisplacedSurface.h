// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   DisplacedSurface
 * @brief   the surface to which a recipe displaces a coarse mesh, for metrics
 *
 * RefinementView has it where a height map displaces the mesh. Private to the module's own sources.
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

  /// Add what the surface depends on besides the mesh.
  virtual void AddTo(Dependencies& dependencies) const = 0;

  /**
   * The curvature at the points of a mesh, ghosts included. `whole` is what the mesh is a piece of,
   * or nullptr. Where the mesh cannot be displaced, all values are 0.
   */
  virtual DiscreteCurvature ComputeCurvature(
    vtkPolyData* mesh, const GlobalSurfaceInfo* whole) const = 0;
};
}

#endif
