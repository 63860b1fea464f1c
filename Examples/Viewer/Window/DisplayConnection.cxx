// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Window/DisplayConnection.h"

#include "Text/ViewerMessages.h"
#include "Window/MeshStyle.h"
#include "Window/TerrainStyle.h"

#include "vtkCallbackCommand.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkSmartPointer.h"

#include <cstdlib>
#include <string>

namespace
{
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
DisplayConnection::DisplayConnection(ViewerMessages& messages)
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

//------------------------------------------------------------------------------
bool HasDisplay()
{
  const char* display = std::getenv("DISPLAY");
  return display && *display;
}

//------------------------------------------------------------------------------
void SetStyle(vtkRenderWindowInteractor* interactor, bool isTerrain)
{
  const auto style = vtkSmartPointer<vtkInteractorStyle>::Take(
    isTerrain ? static_cast<vtkInteractorStyle*>(TerrainStyle::New()) : MeshStyle::New());
  interactor->SetInteractorStyle(style);
}

//------------------------------------------------------------------------------
void EndWithWindow(vtkRenderWindowInteractor* interactor)
{
  vtkNew<vtkCallbackCommand> leave;
  leave->SetCallback(Leave);
  interactor->AddObserver(vtkCommand::ExitEvent, leave);
}
