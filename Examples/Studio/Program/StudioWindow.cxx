// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Program/StudioWindow.h"

#include "Program/ScriptRunner.h"
#include "Program/Studio.h"
#include "Program/StudioPointer.h"
#include "Scene/OffscreenWindow.h"
#include "Scene/PassiveObserver.h"
#include "Text/StandardError.h"
#include "Window/DisplayConnection.h"
#include "Window/ViewerFrames.h"
#include "Window/ViewerServer.h"

#include "vtkCommand.h"
#include "vtkGenericRenderWindowInteractor.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"

namespace
{
const unsigned long PlayDelay = 100; // milliseconds between time steps

// Draws frames that loading or playing needs.
class StudioTimers
{
public:
  StudioTimers(Studio& studio, vtkRenderWindowInteractor* interactor)
    : Driven(studio)
    , Interactor(interactor)
  {
    AddPassiveObserver(
      interactor->GetRenderWindow(), vtkCommand::EndEvent, [this](void*) { this->OnFrame(); });
    AddPassiveObserver(interactor, vtkCommand::TimerEvent,
      [this](void* data) { this->OnTimer(*static_cast<int*>(data)); });
  }

private:
  void OnFrame()
  {
    if (this->Timer != 0)
    {
      return;
    }
    this->IsStep = this->Driven.IsPlaying();
    const std::optional<int> delay = this->Driven.GetScene().Get().GetFrameDelay();
    if (this->IsStep || delay)
    {
      this->Timer = this->Interactor->CreateOneShotTimer(
        this->IsStep ? PlayDelay : static_cast<unsigned long>(*delay));
    }
  }

  void OnTimer(int timer)
  {
    if (timer != this->Timer)
    {
      return;
    }
    this->Timer = 0;
    if (this->IsStep)
    {
      this->Driven.ShowNextStep();
    }
    this->Interactor->Render();
  }

  Studio& Driven;
  vtkRenderWindowInteractor* Interactor;
  int Timer = 0; // 0 for none
  bool IsStep = false;
};

// Draws a studio after all waiting events.
class StudioTools
{
public:
  StudioTools(Studio& studio, vtkRenderWindowInteractor* interactor)
    : Frames(interactor, [&studio] { Update(studio); })
    , Timers(studio, interactor)
    , Pointer(studio, interactor, true)
  {
  }

private:
  static void Update(Studio& studio)
  {
    studio.Apply();
    const std::string error = studio.TakeError();
    if (!error.empty())
    {
      WriteMessage("error", error);
    }
  }

  ViewerFrames Frames;
  const StudioTimers Timers;
  const StudioPointer Pointer;
};
}

//------------------------------------------------------------------------------
void ShowStudio(const OptionValues& values, const std::string& layoutFile)
{
  if (!HasDisplay())
  {
    throw ViewerError("there is no display; use --script FILE to run a script without one");
  }
  const ViewerOptions options = values.Parse();
  ViewerMessages messages;
  const DisplayConnection connection(messages);
  vtkNew<vtkRenderWindow> window;
  messages.ThrowErrorsOf(window);
  window->SetSize(options.Size[0], options.Size[1]);
  window->SetWindowName(("relevo-studio " + options.Input).c_str());
  vtkNew<vtkRenderWindowInteractor> interactor;
  interactor->SetRenderWindow(window);
  SetStyle(interactor, options.IsTerrain() && !options.Globe);
  EndWithWindow(interactor);
  Studio studio(window, values, false);
  studio.SetLayoutFile(layoutFile);
  const StudioTools tools(studio, interactor);
  studio.Draw();
  interactor->Start();
}

//------------------------------------------------------------------------------
void ServeStudio(const OptionValues& values, const std::string& layoutFile, int port)
{
  const ViewerOptions options = values.Parse();
  ViewerMessages messages;
  const auto window = NewOffscreenWindow();
  messages.ThrowErrorsOf(window);
  window->SetSize(options.Size[0], options.Size[1]);
  window->SetMultiSamples(4);
  ViewerServer server(window, messages);
  SetStyle(window->GetInteractor(), options.IsTerrain() && !options.Globe);
  Studio studio(window, values, false);
  studio.SetLayoutFile(layoutFile);
  const StudioTools tools(studio, window->GetInteractor());
  studio.Draw();
  server.Run(port);
}

//------------------------------------------------------------------------------
void RunScript(const OptionValues& values, const std::string& layoutFile, const std::string& script)
{
  const ViewerOptions options = values.Parse();
  const auto window = NewOffscreenWindow();
  window->SetSize(options.Size[0], options.Size[1]);
  window->SetMultiSamples(4);
  Studio studio(window, values, true);
  studio.SetLayoutFile(layoutFile);
  vtkNew<vtkGenericRenderWindowInteractor> interactor;
  interactor->SetRenderWindow(window);
  SetStyle(interactor, options.IsTerrain() && !options.Globe);
  interactor->Enable();
  ScriptRunner runner(studio, interactor);
  const int errors = runner.Run(script);
  if (errors > 0)
  {
    throw ViewerError(
      script + ": " + std::to_string(errors) + (errors == 1 ? " line" : " lines") + " failed");
  }
}
