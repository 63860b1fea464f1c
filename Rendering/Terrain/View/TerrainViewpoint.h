// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   TerrainViewpoint
 * @brief   the view of a renderer's camera, in the coordinates of an actor
 *
 * Private to the module.
 */
#ifndef TerrainViewpoint_h
#define TerrainViewpoint_h

#include "Bisection/TerrainView.h"

#include <array>

class vtkActor;
class vtkRenderer;

namespace relevo
{
class Dependencies;

class TerrainViewpoint
{
public:
  TerrainViewpoint(vtkRenderer* renderer, vtkActor* actor);

  /// Return whether the actor's matrix and the camera define a view.
  bool IsValid() const { return this->Valid; }

  /// Return the view of a terrain that has this position in the actor's coordinates.
  TerrainView MakeView(const TerrainPlacement& placement) const;

  /// Add everything that the view depends on.
  void AddTo(Dependencies& dependencies) const;

  /// Return the point near which positions need the smallest rounding errors: the eye or, with a
  /// parallel projection, the focal point.
  const std::array<double, 3>& GetNearPoint() const { return this->NearPoint; }

  /// Return half of the width and height of the viewport, in pixels.
  const std::array<double, 2>& GetHalfViewport() const { return this->HalfViewport; }

  /// Return the longest side of a triangle in pixels; infinite unless it is wholly before the eye.
  double GetLongestSide(const std::array<std::array<double, 3>, 3>& corners) const;

private:
  bool Valid = false;
  bool IsParallel = false;
  bool IsCulled = true;
  bool IsTranslucent = false; // a globe shows its far side
  std::array<double, 3> NearPoint = { { 0.0, 0.0, 0.0 } };
  double PixelsPerUnit = 1.0;
  double NearestDistance = 0.0;
  std::array<std::array<double, 4>, 6> Planes{};
  std::array<double, 2> HalfViewport = { { 0.0, 0.0 } }; // pixels
};
}

#endif
