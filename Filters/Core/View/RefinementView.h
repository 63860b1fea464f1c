// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @struct  relevo::RefinementView
 * @brief   from where, and on what, a mesh is looked at: the input of view-dependent metrics
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
  /// The camera, in world coordinates; nullptr when nothing is known of the view.
  vtkCamera* Camera = nullptr;
  /// The actor's matrix, from the mesh's coordinates to the world's; nullptr for identity.
  vtkMatrix4x4* ModelToWorld = nullptr;
  /// Width and height of the viewport in pixels.
  int ViewportSize[2] = { 300, 300 };
  /// The patterns that refine faces, where they are known: for metrics that bound deviations.
  std::shared_ptr<const PatternFamily> Patterns = nullptr;
  /// The displaced surface, for metrics that measure it; nullptr without a height map.
  std::shared_ptr<const DisplacedSurface> Displaced = nullptr;

  /**
   * Add the mesh's placement, or what the camera sees: their values, not when they were last
   * changed.
   */
  RELEVOFILTERSCORE_EXPORT void AddTo(
    Dependencies& dependencies, bool addsPlacement, bool addsCamera) const;
};
}

#endif
