// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Window/ViewerServer.h"

#include "Options/ViewerOptions.h"
#include "Scene/OffscreenWindow.h"
#include "Scene/ReliefCaptures.h"
#include "Scene/ViewerScene.h"
#include "Text/ViewerMessages.h"
#include "Window/DisplayConnection.h"
#include "Window/ViewerTools.h"

#include "vtkObjectBase.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"

#ifdef VIEWER_HAS_REMOTE
#include "vtkWindowServer.h"
#endif

#include <csignal>
#include <iostream>

#ifdef VIEWER_HAS_REMOTE
namespace
{
volatile std::sig_atomic_t IsInterrupted = 0;

void Interrupt(int)
{
  IsInterrupted = 1;
}

// While it lives, SIGINT and SIGTERM end a loop instead of the program.
class SignalHandlers
{
public:
  SignalHandlers()
    : OldInterrupt(std::signal(SIGINT, Interrupt))
    , OldTerminate(std::signal(SIGTERM, Interrupt))
  {
  }

  ~SignalHandlers()
  {
    std::signal(SIGINT, this->OldInterrupt);
    std::signal(SIGTERM, this->OldTerminate);
  }

private:
  void (*OldInterrupt)(int);
  void (*OldTerminate)(int);
};

const double SignalDelay = 0.1; // seconds until signals are noticed
}

//------------------------------------------------------------------------------
ViewerServer::ViewerServer(vtkRenderWindow* window, ViewerMessages& messages)
  : Messages(messages)
  , Server(vtkSmartPointer<vtkWindowServer>::New())
{
  messages.Observe(this->Server);
  this->Server->SetRenderWindow(window);
}

//------------------------------------------------------------------------------
ViewerServer::~ViewerServer() = default;

//------------------------------------------------------------------------------
void ViewerServer::Run(int port)
{
  this->Server->SetPort(port);
  if (!this->Server->Start())
  {
    this->Messages.Check();
    throw ViewerError("the window cannot be served");
  }
  const SignalHandlers handlers;
  std::cout << "open " << this->Server->GetURL() << std::endl;
  while (!IsInterrupted && this->Server->ProcessRequests(SignalDelay))
  {
  }
  this->Server->Stop();
}
#else
class vtkWindowServer : public vtkObjectBase
{
};

//------------------------------------------------------------------------------
ViewerServer::ViewerServer(vtkRenderWindow*, ViewerMessages& messages)
  : Messages(messages)
{
  throw ViewerError("this build of Relevo does not have civetweb, which --serve needs");
}

//------------------------------------------------------------------------------
ViewerServer::~ViewerServer() = default;

//------------------------------------------------------------------------------
void ViewerServer::Run(int)
{
}
#endif

//------------------------------------------------------------------------------
void ServeScene(ViewerScene& scene, const ViewerOptions& options, ViewerMessages& messages)
{
  const auto window = NewOffscreenWindow();
  messages.ThrowErrorsOf(window);
  window->SetSize(options.Size[0], options.Size[1]);
  window->SetMultiSamples(4);
  window->AddRenderer(scene.GetRenderer());
  ViewerServer server(window, messages);
  SetStyle(window->GetInteractor(), options.IsTerrain() && !options.Globe);
  const ViewerTools tools(window->GetInteractor(), scene, options, messages);
  scene.Draw(window);
  ShowReliefs(scene.GetRenderer(), window, options, messages);
  server.Run(*options.Serve);
}
