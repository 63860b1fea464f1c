// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Window/ViewerWindow.h"

#include "Options/ViewerOptions.h"
#include "Scene/ReliefCaptures.h"
#include "Scene/ViewerScene.h"
#include "Text/ViewerMessages.h"
#include "Window/MeshStyle.h"
#include "Window/TerrainStyle.h"
#include "Window/ViewerFrames.h"
#include "Window/ViewerHelp.h"
#include "Window/ViewerKeys.h"
#include "Window/ViewerReadout.h"
#include "Window/ViewerScaleBar.h"
#include "Window/ViewerScreenshot.h"

#include "vtkCallbackCommand.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"

#include <cstdlib>
#include <string>

namespace
{
// By a window of its own, never shown: a window that was asked for the size of its screen before it
// has an interactor owns the connection to the display, and takes it away from under VTK 9.1's
// interactor when it closes.
void CheckDisplay(ViewerMessages& messages)
{
  vtkNew<vtkRenderWindow> window;
  // At once, for VTK ends the program after its message that the display cannot be reached.
  messages.ThrowErrorsOf(window);
  window->GetScreenSize();
  // VTK 9.4 and later make a window without display of it instead.
  if (!window->GetShowWindow())
  {
    throw ViewerError("cannot reach DISPLAY=" + std::string(std::getenv("DISPLAY")) +
      "; --output FILE.png draws a picture without one");
  }
}

// A terrain has a vertical; a mesh is turned in the hand.
vtkSmartPointer<vtkInteractorStyle> MakeStyle(bool isTerrain)
{
  return vtkSmartPointer<vtkInteractorStyle>::Take(
    isTerrain ? static_cast<vtkInteractorStyle*>(TerrainStyle::New()) : MeshStyle::New());
}

// Events that wait are those of a window that will be gone: the X server ends programs that ask
// where the mouse is in it.
void Leave(vtkObject* caller, unsigned long, void*, void*)
{
  auto* interactor = static_cast<vtkRenderWindowInteractor*>(caller);
  interactor->Disable();
  interactor->ProcessEvents();
  interactor->TerminateApp();
}
}

//------------------------------------------------------------------------------
bool HasDisplay()
{
  const char* display = std::getenv("DISPLAY");
  return display && *display;
}

//------------------------------------------------------------------------------
void ShowWindow(ViewerScene& scene, const ViewerOptions& options, ViewerMessages& messages)
{
  CheckDisplay(messages);
  vtkNew<vtkRenderWindow> window;
  messages.ThrowErrorsOf(window);
  window->SetSize(options.Size[0], options.Size[1]);
  window->SetWindowName(("relevo-view " + options.Input).c_str());
  window->AddRenderer(scene.GetRenderer());
  vtkNew<vtkRenderWindowInteractor> interactor;
  interactor->SetRenderWindow(window);
  interactor->SetInteractorStyle(MakeStyle(options.IsTerrain()));
  vtkNew<vtkCallbackCommand> leave;
  leave->SetCallback(Leave);
  interactor->AddObserver(vtkCommand::ExitEvent, leave);
  ViewerFrames frames(interactor);
  const ViewerScaleBar scaleBar(scene.GetRenderer(), scene.GetUnit());
  const ViewerReadout readout(interactor, frames, scene);
  const ViewerHelp help(interactor, scene.GetRenderer());
  const ViewerKeys keys(interactor, scene);
  const ViewerScreenshot screenshot(
    interactor, frames, options.Input, { readout.GetText(), help.GetText() }, messages);
  scene.Draw(window);
  ShowReliefs(scene.GetRenderer(), window, options, messages);
  interactor->Start();
}
