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

class TerrainProbe;
class vtkDisplacement;

class TerrainCamera : public ViewerCamera
{
public:
  /// The ground near the camera is drawn at one of these levels.
  TerrainCamera(vtkRenderer* renderer, TerrainProbe& probe, vtkDisplacement* displacement,
    int lowestLevel, int highestLevel);

protected:
  void MoveOut(vtkCamera* camera) override;
  double GetMinimumDistance(vtkCamera* camera) override;

private:
  /// Gets the ground's z. Returns false outside the terrain and in holes.
  bool GetGround(double x, double y, double& z);
  /// Whether a position is at least `margin` above the ground, or there is no ground.
  bool IsClear(const double position[3], double margin);
  /// Turns upwards until the position is clear. Returns false if it never is.
  bool TurnUp(const double focus[3], double position[3], double margin);

  TerrainProbe& Probe;
  vtkDisplacement* Displacement;
  int LowestLevel;
  int HighestLevel;
};

#endif
