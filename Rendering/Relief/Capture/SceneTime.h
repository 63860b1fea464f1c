// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   SceneTime
 * @brief   when the appearance of a renderer's props last changed
 *
 * The positions of lights that follow the camera are ignored, because they change in each frame.
 * The camera is ignored, too. Private to the module.
 */
#ifndef SceneTime_h
#define SceneTime_h

#include "Changes/Dependencies.h"
#include "vtkTimeStamp.h"

class vtkRenderer;

namespace relevo
{
class SceneTime
{
public:
  /// Check the props, their data and the lights, and return the time. The renderer may be nullptr
  /// if it has been deleted.
  vtkMTimeType Find(vtkRenderer* renderer);

private:
  Dependencies Lights;
  vtkTimeStamp LightsChanged;
  Dependencies Assemblies;
  vtkTimeStamp AssembliesChanged;
  bool IsFinding = false; // guards against recursion through a prop that shows the output
};
}

#endif
