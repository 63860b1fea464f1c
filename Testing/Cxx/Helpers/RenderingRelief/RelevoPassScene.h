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

  // Pictures while the camera moves, and while it stands still.
  RelevoPicture DrawMoving();
  RelevoPicture DrawStill();

  // Share of the pixels of the still picture's objects where the moving picture shows something
  // behind them.
  double FindHoles();

  // Number of captures that a frame makes.
  vtkIdType CountCaptures();

  vtkActor* Wall = nullptr;
  vtkActor* Ball = nullptr;
  vtkNew<vtkReliefPass> Pass;

private:
  double GetDistance(float z);
};

#endif
