// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @struct  relevo::RefinementView
 * @brief   the input of view-dependent metrics: camera, placement of the mesh, and viewport
 */
#ifndef RefinementView_h
#define RefinementView_h

#include "RelevoFiltersCoreModule.h" // for export macro

#include <memory> // for members

class vtkCamera;
class vtkMatrix4x4;

namespace relevo
{
class Dependencies;
class DisplacedSurface;
class PatternFamily;
struct RefinementView
{
  /// The camera, in world coordinates; nullptr if the view is not known.
  vtkCamera* Camera = nullptr;
  /// The actor's matrix, from the mesh's coordinates to world coordinates; nullptr for the
  /// identity.
  vtkMatrix4x4* ModelToWorld = nullptr;
  /// Width and height of the viewport in pixels.
  int ViewportSize[2] = { 300, 300 };
  /// The patterns that refine faces, if known, for metrics that bound deviations.
  std::shared_ptr<const PatternFamily> Patterns = nullptr;
  /// The displaced surface, for metrics that measure it; nullptr without a height map.
  std::shared_ptr<const DisplacedSurface> Displaced = nullptr;
  /// Whether the mesh is a block of a composite data set, whose border must match other blocks.
  bool IsPart = false;

  /**
   * Add the values of the mesh's placement or of the camera as dependencies. Modification times are
   * not used.
   */
  RELEVOFILTERSCORE_EXPORT void AddTo(
    Dependencies& dependencies, bool addsPlacement, bool addsCamera) const;
};
}

#endif
