// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Window/ViewerWindow.h"

#include "Options/ViewerOptions.h"
#include "Scene/ReliefCaptures.h"
#include "Scene/ViewerScene.h"
#include "Text/ViewerMessages.h"
#include "Window/DisplayConnection.h"
#include "Window/ViewerTools.h"

#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"

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
  const ViewerTools tools(interactor, scene, options, messages);
  scene.Draw(window);
  ShowReliefs(scene.GetRenderer(), window, options, messages);
  interactor->Start();
}
