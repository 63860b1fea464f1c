// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   GlobeCamera
 * @brief   a camera that stays above the ground of a globe
 *
 * If the camera would be below the ground, it turns upwards around its focal point, as
 * TerrainCamera does on a map.
 */
#ifndef GlobeCamera_h
#define GlobeCamera_h

#include "Scene/ViewerCamera.h"

#include "vtkSmartPointer.h"

#include <array>

class vtkTerrainMapper;

class GlobeCamera : public ViewerCamera
{
public:
  /// The mapper has a geocentric frame and an open pyramid.
  GlobeCamera(vtkRenderer* renderer, vtkTerrainMapper* mapper);
  ~GlobeCamera() override;

  /// Keeps positions below the ground, for flights.
  void StayInPlace() { this->StaysInPlace = true; }

protected:
  void MoveOut(vtkCamera* camera) override;
  double GetMinimumDistance(vtkCamera* camera) override;

private:
  using Point = std::array<double, 3>;

  /// The ground below or above a point, and the height of the point above it in metres. Returns
  /// false outside of the raster and in holes.
  bool FindGround(const Point& point, Point& ground, double& height);
  /// The direction up.
  Point FindUp(const Point& point);

  vtkSmartPointer<vtkTerrainMapper> Mapper;
  bool StaysInPlace = false;
};

#endif
