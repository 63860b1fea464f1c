// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   TerrainCamera
 * @brief   a camera that stays above the ground
 *
 * Where it would be in the ground it turns up about its focal point, so that what it looks at stays
 * as large as it was.
 */
#ifndef TerrainCamera_h
#define TerrainCamera_h

#include "Scene/ViewerCamera.h"

class TerrainProbe;
class vtkDisplacement;

class TerrainCamera : public ViewerCamera
{
public:
  /// The ground near the camera is drawn at one of the levels.
  TerrainCamera(vtkRenderer* renderer, TerrainProbe& probe, vtkDisplacement* displacement,
    int lowestLevel, int highestLevel);

protected:
  void MoveOut(vtkCamera* camera) override;
  double GetMinimumDistance(vtkCamera* camera) override;

private:
  /// The ground's z; false beside the terrain and in its holes.
  bool GetGround(double x, double y, double& z);
  /// Whether a position is `margin` above the ground, or there is none.
  bool IsClear(const double position[3], double margin);
  /// Turns up until it is clear; false if it never is.
  bool TurnUp(const double focus[3], double position[3], double margin);

  TerrainProbe& Probe;
  vtkDisplacement* Displacement;
  int LowestLevel;
  int HighestLevel;
};

#endif
