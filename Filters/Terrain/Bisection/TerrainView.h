// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   TerrainView
 * @brief   a camera that looks at a terrain: visibility of boxes and projected errors
 *
 * Private to the modules for terrains.
 */
#ifndef TerrainView_h
#define TerrainView_h

#include "RelevoFiltersTerrainModule.h" // for export macro

#include "Bisection/TerrainBox.h"
#include "Geodesy/TerrainPlacement.h"

#include <array>
#include <memory>

class vtkCamera;

namespace relevo
{
class GlobeView;

class RELEVOFILTERSTERRAIN_EXPORT TerrainView
{
public:
  /// The view of a camera, whose position is in world coordinates, in a viewport of this width and
  /// height in pixels. The far side of the frustum is open.
  void SetCamera(vtkCamera* camera, const int viewport[2]);

  /**
   * A perspective view: the eye in world coordinates, the height of the viewport in pixels divided
   * by 2 tan(angle / 2), and the distance of the nearest points that are drawn.
   */
  void SetPerspective(
    const std::array<double, 3>& eye, double pixelsPerUnit, double nearestDistance);
  /// A parallel view: the height of the viewport in pixels divided by twice the parallel scale.
  void SetParallel(double pixelsPerUnit);
  /// The planes of the frustum: a x + b y + c z + d >= 0 inside, in world coordinates.
  void SetFrustum(const std::array<std::array<double, 4>, 6>& planes);
  /// Set whether a globe hides what is behind its horizon in perspective views; default true.
  void SetHorizon(bool hasHorizon) { this->HasHorizon = hasHorizon; }
  void SetPlacement(const TerrainPlacement& placement);
  const TerrainPlacement& GetPlacement() const { return this->Placement; }

  /// The column and row below the eye of a perspective view.
  const std::array<double, 2>& GetRasterEye() const { return this->RasterEye; }

  /// Whether a part of the box may lie inside of the frustum.
  bool IsVisible(const TerrainBox& box) const;

  /**
   * The size in pixels of a vertical distance anywhere in a box, at most. It does not grow if the
   * box shrinks. 0 for the distance 0, and in an empty box (whose first height is the larger one).
   */
  double Project(double distance, const TerrainBox& box) const;
  /// The same for a distance in world units in any direction.
  double ProjectLength(double length, const TerrainBox& box) const;

  /**
   * The vertical distance between the terrain and faces of a level whose vertices lie on it, at
   * most, in the unit of the heights: 0 on a map. See GlobeView. It adds to BlockErrors.
   */
  double GetShapeError(int level, bool isSquare, const TerrainBox& box) const;

private:
  bool IsParallel = true;
  double PixelsPerUnit = 1.0;
  double NearestDistance = 0.0;
  std::array<double, 3> Eye = { { 0.0, 0.0, 0.0 } };
  std::array<double, 2> RasterEye = { { 0.0, 0.0 } }; // column and row
  std::array<double, 2> Lengths = { { 1.0, 1.0 } };   // of a column and a row, at most
  std::array<std::array<double, 4>, 6> Planes{};
  bool HasPlanes = false;
  bool HasHorizon = true;
  TerrainPlacement Placement;
  std::shared_ptr<const GlobeView> Globe; // nullptr on a map
};
}

#endif
