// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Window/ViewerTools.h"

#include "Options/ViewerOptions.h"
#include "Scene/ViewerScene.h"

#include "vtkRenderWindowInteractor.h"

#include <vector>

//------------------------------------------------------------------------------
ViewerTools::ViewerTools(vtkRenderWindowInteractor* interactor, ViewerScene& scene,
  const ViewerOptions& options, ViewerMessages& messages)
  : Frames(interactor)
  , Loading(interactor, scene)
  , ScaleBar(scene.GetRenderer(), scene.GetUnit())
  , Axes(options.IsTerrain() ? nullptr : std::make_unique<AxesTriad>(scene.GetRenderer()))
  , Ruler(options.IsTerrain() ? nullptr
                              : std::make_unique<ViewerRuler>(interactor, this->Frames, scene))
  , Readout(interactor, this->Frames, scene)
  , Help(interactor, scene.GetRenderer())
  , Keys(interactor, scene)
  , Screenshot(interactor, this->Frames, options.Input,
      { this->Readout.GetText(), this->Help.GetText() }, messages)
{
}
