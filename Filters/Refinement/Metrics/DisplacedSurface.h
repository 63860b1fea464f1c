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
#include "Metrics/DisplacedFaces.h"    // for return value

#include <memory> // for return value

class vtkPolyData;

namespace relevo
{
class Dependencies;
class PatternFamily;
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

  /**
   * Prepare the faces of a mesh, without ghost cells, for measuring them with these patterns.
   * Returns nullptr if the mesh cannot be displaced.
   */
  virtual std::unique_ptr<DisplacedFaces> MakeFaces(vtkPolyData* mesh,
    const GlobalSurfaceInfo* whole, std::shared_ptr<const PatternFamily> patterns) const = 0;

  /// The highest level of an edge of the recipe.
  virtual int GetMaximumLevel() const = 0;
};
}

#endif
