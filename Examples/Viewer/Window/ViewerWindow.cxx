// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Window/ViewerWindow.h"

#include "Options/ViewerOptions.h"
#include "Scene/AxesTriad.h"
#include "Scene/ReliefCaptures.h"
#include "Scene/ViewerScene.h"
#include "Text/ViewerMessages.h"
#include "Window/DisplayConnection.h"
#include "Window/ViewerFrames.h"
#include "Window/ViewerHelp.h"
#include "Window/ViewerKeys.h"
#include "Window/ViewerLoading.h"
#include "Window/ViewerReadout.h"
#include "Window/ViewerRuler.h"
#include "Window/ViewerScaleBar.h"
#include "Window/ViewerScreenshot.h"

#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"

#include <memory>
#include <string>

//------------------------------------------------------------------------------
void ShowWindow(ViewerScene& scene, const ViewerOptions& options, ViewerMessages& messages)
{
  const DisplayConnection connection(messages);
  vtkNew<vtkRenderWindow> window;
  messages.ThrowErrorsOf(window);
  window->SetSize(options.Size[0], options.Size[1]);
  window->SetWindowName(("relevo-view " + options.Input).c_str());
  window->AddRenderer(scene.GetRenderer());
  vtkNew<vtkRenderWindowInteractor> interactor;
  interactor->SetRenderWindow(window);
  SetStyle(interactor, options.IsTerrain() && !options.Globe);
  EndWithWindow(interactor);
  ViewerFrames frames(interactor);
  const ViewerLoading loading(interactor, scene);
  const ViewerScaleBar scaleBar(scene.GetRenderer(), scene.GetUnit());
  std::unique_ptr<AxesTriad> axes;
  std::unique_ptr<ViewerRuler> ruler;
  if (!options.IsTerrain())
  {
    axes = std::make_unique<AxesTriad>(scene.GetRenderer());
    ruler = std::make_unique<ViewerRuler>(interactor, frames, scene);
  }
  const ViewerReadout readout(interactor, frames, scene);
  const ViewerHelp help(interactor, scene.GetRenderer());
  const ViewerKeys keys(interactor, scene);
  const ViewerScreenshot screenshot(
    interactor, frames, options.Input, { readout.GetText(), help.GetText() }, messages);
  scene.Draw(window);
  ShowReliefs(scene.GetRenderer(), window, options, messages);
  interactor->Start();
}
