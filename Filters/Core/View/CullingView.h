// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @struct  CullingView
 * @brief   the frustum and eye of a camera, relative to an origin in model coordinates
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
   * `aspect` is width / height. `margins` are the distances that drawn objects reach beyond their
   * points horizontally and vertically, as fractions of half the width and height. With a singular
   * matrix, the view culls nothing.
   */
  CullingView(vtkCamera* camera, double aspect, vtkMatrix4x4* modelToWorld, const double origin[3],
    const std::array<double, 2>& margins = { { 0.0, 0.0 } });

  static constexpr int NumberOfPlanes = 5;
  /// The sides of the frustum and the plane of the eye, pointing inside.
  float Planes[NumberOfPlanes][4];
  /// The near plane, pointing inside.
  float Near[4];
  /// The position of the eye, or with a parallel camera the direction towards it.
  float Eye[3];
  bool Parallel;
  bool Valid;

  /// Add everything except the near plane, which few users need.
  void AddTo(Dependencies& dependencies) const;
};
}

#endif
