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
/**
 * A connection to the display, by a window that is never shown. It stays open until the program's
 * own window is closed: some X servers reset when their last client leaves, and then refuse the
 * next one. The program's own window cannot be asked for its screen before it has an interactor: it
 * would own the connection, and close it while VTK 9.1's interactor still uses it.
 */
class DisplayConnection
{
public:
  explicit DisplayConnection(ViewerMessages& messages)
  {
    // Errors end the program at once, for VTK ends it after its message that it cannot connect.
    messages.ThrowErrorsOf(this->Window);
    this->Window->GetScreenSize();
    // VTK 9.4 and later make a window without display of it instead.
    if (!this->Window->GetShowWindow())
    {
      throw ViewerError("cannot reach DISPLAY=" + std::string(std::getenv("DISPLAY")) +
        "; --output FILE.png draws a picture without one");
    }
  }

private:
  vtkNew<vtkRenderWindow> Window;
};

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
  const DisplayConnection connection(messages);
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
