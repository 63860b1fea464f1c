// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   SceneTime
 * @brief   when what a renderer's props look like last changed
 *
 * Lights that follow the camera are moved whenever it is drawn: their places do not count, and nor
 * does the camera. Private to the module.
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
  /// Looks at props, their data, and lights; nullptr if the renderer is gone.
  vtkMTimeType Find(vtkRenderer* renderer);

private:
  Dependencies Lights;
  vtkTimeStamp LightsChanged;
  Dependencies Assemblies;
  vtkTimeStamp AssembliesChanged;
  bool IsFinding = false; // a prop may show what this is the time of
};
}

#endif
