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
#include "Window/ViewerLoading.h"
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
/**
 * A connection to the display by a window that is never shown. It stays open until the program's
 * window is closed, because some X servers reset when their last client disconnects, and then
 * refuse the next one. The program's window cannot query the screen before it has an interactor: it
 * would own the connection and close it while VTK 9.1's interactor still uses it.
 */
class DisplayConnection
{
public:
  explicit DisplayConnection(ViewerMessages& messages)
  {
    // Errors end the program at once, because VTK would exit after its message.
    messages.ThrowErrorsOf(this->Window);
    this->Window->GetScreenSize();
    // VTK 9.4 and later create a window without a display instead.
    if (!this->Window->GetShowWindow())
    {
      throw ViewerError("cannot open DISPLAY=" + std::string(std::getenv("DISPLAY")) +
        "; use --output FILE.png to write a picture without a display");
    }
  }

private:
  vtkNew<vtkRenderWindow> Window;
};

// A terrain has a vertical axis, a mesh rotates freely.
vtkSmartPointer<vtkInteractorStyle> MakeStyle(bool isTerrain)
{
  return vtkSmartPointer<vtkInteractorStyle>::Take(
    isTerrain ? static_cast<vtkInteractorStyle*>(TerrainStyle::New()) : MeshStyle::New());
}

// Removes waiting events of a closed window: the X server ends programs that query the mouse in it.
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
  const DisplayConnection connection(messages);
  vtkNew<vtkRenderWindow> window;
  messages.ThrowErrorsOf(window);
  window->SetSize(options.Size[0], options.Size[1]);
  window->SetWindowName(("relevo-view " + options.Input).c_str());
  window->AddRenderer(scene.GetRenderer());
  vtkNew<vtkRenderWindowInteractor> interactor;
  interactor->SetRenderWindow(window);
  interactor->SetInteractorStyle(MakeStyle(options.IsTerrain() && !options.Globe));
  vtkNew<vtkCallbackCommand> leave;
  leave->SetCallback(Leave);
  interactor->AddObserver(vtkCommand::ExitEvent, leave);
  ViewerFrames frames(interactor);
  const ViewerLoading loading(interactor, scene);
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
