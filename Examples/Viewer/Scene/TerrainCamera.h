// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   TerrainCamera
 * @brief   a camera that stays above the ground
 *
 * If the camera would be below the ground, it turns upwards around its focal point, so that the
 * scale of the view stays.
 */
#ifndef TerrainCamera_h
#define TerrainCamera_h

#include "Scene/ViewerCamera.h"

class TerrainGround;

class TerrainCamera : public ViewerCamera
{
public:
  TerrainCamera(vtkRenderer* renderer, TerrainGround& ground);

  /// Keeps positions below the ground, for flights.
  void StayInPlace() { this->StaysInPlace = true; }

protected:
  void MoveOut(vtkCamera* camera) override;
  double GetMinimumDistance(vtkCamera* camera) override;

private:
  /// Whether a position is at least `margin` above the ground, or there is no ground.
  bool IsClear(const double position[3], double margin);
  /// Turns upwards until the position is clear. Returns false if it never is.
  bool TurnUp(const double focus[3], double position[3], double margin);

  TerrainGround& Ground;
  bool StaysInPlace = false;
};

#endif
