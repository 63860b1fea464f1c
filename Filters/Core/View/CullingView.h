// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @struct  CullingView
 * @brief   the frustum and the eye of a camera, relative to an origin in the model's coordinates
 *
 * Private to Relevo's own sources.
 */
#ifndef CullingView_h
#define CullingView_h

#include "RelevoFiltersCoreModule.h" // for export macro

#include <array> // for margins

class vtkCamera;
class vtkMatrix4x4;

namespace relevo
{
class Dependencies;

struct RELEVOFILTERSCORE_EXPORT CullingView
{
  /**
   * `aspect` is width over height. `margins` are what drawn things reach beyond their points to the
   * sides and up and down, as shares of half the width and height. A matrix that cannot be inverted
   * gives a view that hides nothing.
   */
  CullingView(vtkCamera* camera, double aspect, vtkMatrix4x4* modelToWorld, const double origin[3],
    const std::array<double, 2>& margins = { { 0.0, 0.0 } });

  static constexpr int NumberOfPlanes = 5;
  /// Sides of the frustum and the plane of the eye, pointing inside.
  float Planes[NumberOfPlanes][4];
  /// The near plane, pointing inside.
  float Near[4];
  /// Position of the eye, or with a parallel camera the direction towards it.
  float Eye[3];
  bool Parallel;
  bool Valid;

  /// All but the near plane, which matters to few users.
  void AddTo(Dependencies& dependencies) const;
};
}

#endif
