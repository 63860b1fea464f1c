// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// A window with a vtkReliefPass: balls in front of a wall.
#ifndef RelevoPassScene_h
#define RelevoPassScene_h

#include "RelevoCaptureScene.h"

#include "vtkReliefPass.h"

class RelevoPassScene : public RelevoCaptureScene
{
public:
  RelevoPassScene();

  // What is shown while the camera moves, and when it stands.
  RelevoPicture DrawMoving();
  RelevoPicture DrawStill();

  // The share of pixels of the still picture's objects that the moving one shows behind them.
  double FindHoles();

  // Captures that a frame makes.
  vtkIdType CountCaptures();

  vtkActor* Wall = nullptr;
  vtkActor* Ball = nullptr;
  vtkNew<vtkReliefPass> Pass;

private:
  double GetDistance(float z);
};

#endif
