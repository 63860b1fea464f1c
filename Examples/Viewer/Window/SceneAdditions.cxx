// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Window/SceneAdditions.h"

#include "Options/ViewerOptions.h"
#include "Scene/ViewerScene.h"

//------------------------------------------------------------------------------
void SceneAdditions::Show(ViewerScene& scene, const ViewerOptions& options)
{
  this->ScaleBar.reset();
  if (options.HasScaleBar)
  {
    this->ScaleBar = std::make_unique<ViewerScaleBar>(scene.GetRenderer(), scene.GetUnit());
  }
  this->Axes.reset();
  if (options.HasAxes)
  {
    this->Axes = std::make_unique<AxesTriad>(scene.GetRenderer());
  }
  scene.HideRuler();
  if (options.Ruler)
  {
    const std::vector<double>& ends = *options.Ruler;
    scene.ShowRuler({ { ends[0], ends[1], ends[2] } }, { { ends[3], ends[4], ends[5] } });
  }
}
