// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWindowServer.h"

#include "Checks/SettingChecks.h"
#include "Connection/AccessToken.h"
#include "Connection/RequestCheck.h"
#include "Connection/WebServer.h"
#include "Messages/Inbox.h"
#include "Pictures/PictureEncoder.h"
#include "Window/EventInteractor.h"
#include "Window/EventPlayer.h"
#include "Window/FrameRequests.h"

#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkRenderWindow.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <vector>

namespace
{
using ServerClock = std::chrono::steady_clock;
const double LongestWait = 1e6;         // seconds
const std::size_t LongestToken = 128;   // characters
const std::size_t LongestAddress = 128; // characters

ServerClock::duration ToDuration(double seconds)
{
  return std::chrono::duration_cast<ServerClock::duration>(std::chrono::duration<double>(seconds));
}
}

struct vtkWindowServer::Internals
{
  std::string Address = "127.0.0.1";
  std::string Token = relevo::MakeToken();
  std::string URL;

  vtkSmartPointer<vtkRenderWindow> Window;
  // The window's interactor, if it has no other one.
  vtkSmartPointer<relevo::EventInteractor> Interactor;
  unsigned long Observer = 0;
  relevo::EventPlayer Player;
  bool IsProcessing = false;

  std::uint64_t Frame = 0; // number of the last frame; 0 if none was seen
  std::array<int, 2> FrameSize = { { 0, 0 } };
  ServerClock::time_point FrameTime; // of the last frame
  vtkNew<vtkUnsignedCharArray> Pixels;

  std::atomic<vtkTypeInt64> NumberOfPictures{ 0 };
  vtkTypeInt64 NumberOfReadFrames = 0;

  relevo::Inbox Messages;
  std::unique_ptr<relevo::WebServer> Server;
  std::unique_ptr<relevo::PictureEncoder> Encoder; // ends before the server that it sends to

  bool IsStill(double delay) const
  {
    return ServerClock::now() - this->FrameTime >= ToDuration(delay);
  }

  // When there is something to do, if no message comes first.
  ServerClock::time_point GetNextTime(ServerClock::time_point end, double stillDelay) const
  {
    if (this->Interactor)
    {
      end = std::min(end, this->Interactor->GetNextTimer().value_or(end));
    }
    if (this->Frame > 0 && !this->IsStill(stillDelay) && this->Server->IsLacking(this->Frame))
    {
      end = std::min(end, this->FrameTime + ToDuration(stillDelay));
    }
    return end;
  }
};

vtkStandardNewMacro(vtkWindowServer);

//------------------------------------------------------------------------------
vtkWindowServer::vtkWindowServer()
  : State(std::make_unique<Internals>())
{
}

//------------------------------------------------------------------------------
vtkWindowServer::~vtkWindowServer()
{
  this->Stop();
  this->SetRenderWindow(nullptr);
}

//------------------------------------------------------------------------------
void vtkWindowServer::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "RenderWindow: " << this->State->Window.GetPointer() << "\n";
  os << indent << "Address: " << this->State->Address << "\n";
  os << indent << "Port: " << this->Port << "\n";
  os << indent << "ActivePort: " << this->GetActivePort() << "\n";
  os << indent << "JPEGQuality: " << this->JPEGQuality << "\n";
  os << indent << "StillDelay: " << this->StillDelay << "\n";
  os << indent << "AllowResizing: " << this->AllowResizing << "\n";
  os << indent << "NumberOfClients: " << this->GetNumberOfClients() << "\n";
  os << indent << "NumberOfPictures: " << this->GetNumberOfPictures() << "\n";
  os << indent << "NumberOfReadFrames: " << this->GetNumberOfReadFrames() << "\n";
}

//------------------------------------------------------------------------------
void vtkWindowServer::SetRenderWindow(vtkRenderWindow* window)
{
  Internals& state = *this->State;
  if (state.Window == window)
  {
    return;
  }
  if (state.Window)
  {
    state.Window->RemoveObserver(state.Observer);
    if (state.Interactor && state.Window->GetInteractor() == state.Interactor)
    {
      state.Player.ReleaseAll(state.Window);
      state.Interactor->SetRenderWindow(nullptr);
      state.Window->SetInteractor(nullptr);
    }
  }
  state.Interactor = nullptr;
  state.Window = window;
  state.FrameSize = { { 0, 0 } };
  state.FrameTime = ServerClock::time_point();
  if (window)
  {
    state.Observer = window->AddObserver(vtkCommand::EndEvent, this, &vtkWindowServer::OnFrame);
    if (!window->GetInteractor())
    {
      state.Interactor = vtkSmartPointer<relevo::EventInteractor>::New();
      state.Interactor->SetRenderWindow(window);
      state.Interactor->Initialize();
    }
  }
  this->Modified();
}

//------------------------------------------------------------------------------
vtkRenderWindow* vtkWindowServer::GetRenderWindow()
{
  return this->State->Window;
}

//------------------------------------------------------------------------------
void vtkWindowServer::SetPort(int port)
{
  relevo::SetInRange(this, "Port", this->Port, port, 0, 65535);
}

//------------------------------------------------------------------------------
int vtkWindowServer::GetActivePort()
{
  return this->State->Server ? this->State->Server->GetPort() : 0;
}

//------------------------------------------------------------------------------
void vtkWindowServer::SetAddress(const std::string& address)
{
  const std::string characters = "0123456789abcdefABCDEF.:[]";
  if (address.empty() || address.size() > LongestAddress ||
    address.find_first_not_of(characters) != std::string::npos)
  {
    vtkErrorMacro(
      "Address must be a numeric address such as 127.0.0.1 or 0.0.0.0, got '" << address << "'.");
  }
  else if (address != this->State->Address)
  {
    this->State->Address = address;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
std::string vtkWindowServer::GetAddress()
{
  return this->State->Address;
}

//------------------------------------------------------------------------------
void vtkWindowServer::SetToken(const std::string& token)
{
  if (!token.empty() && (token.size() > LongestToken || !relevo::IsToken(token)))
  {
    vtkErrorMacro(
      "Token must have at most " << LongestToken << " letters, digits and characters - . _ ~.");
  }
  else if (token.empty() || token != this->State->Token)
  {
    this->State->Token = token.empty() ? relevo::MakeToken() : token;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
std::string vtkWindowServer::GetToken()
{
  return this->State->Token;
}

//------------------------------------------------------------------------------
std::string vtkWindowServer::GetURL()
{
  return this->State->URL;
}

//------------------------------------------------------------------------------
void vtkWindowServer::SetJPEGQuality(int quality)
{
  relevo::SetInRange(this, "JPEGQuality", this->JPEGQuality, quality, 1, 100);
}

//------------------------------------------------------------------------------
void vtkWindowServer::SetStillDelay(double seconds)
{
  relevo::SetInRange(this, "StillDelay", this->StillDelay, seconds, 0.0, 3600.0);
}

//------------------------------------------------------------------------------
bool vtkWindowServer::Start()
{
  Internals& state = *this->State;
  if (state.Server)
  {
    return true;
  }
  if (!state.Window)
  {
    vtkErrorMacro("There is no window to serve. Call SetRenderWindow() before Start().");
    return false;
  }
  if (state.Token.empty())
  {
    vtkErrorMacro("The random source of the system, /dev/urandom, cannot be read. Use SetToken().");
    return false;
  }
  const relevo::RequestCheck check(state.Address, state.Token);
  auto server = std::make_unique<relevo::WebServer>(state.Messages, check);
  const std::string problem = server->Start(state.Address, this->Port);
  if (!problem.empty())
  {
    vtkErrorMacro(<< problem);
    return false;
  }
  state.URL = "http://" + check.GetHostName() + ":" + std::to_string(server->GetPort()) +
    "/?token=" + state.Token;
  state.NumberOfPictures = 0;
  state.NumberOfReadFrames = 0;
  state.Server = std::move(server);
  relevo::WebServer* receiver = state.Server.get();
  state.Encoder = std::make_unique<relevo::PictureEncoder>(
    [&state, receiver](const std::shared_ptr<const relevo::EncodedPicture>& picture)
    { state.NumberOfPictures += receiver->Send(picture); },
    [&state] { state.Messages.Wake(); });
  return true;
}

//------------------------------------------------------------------------------
bool vtkWindowServer::ProcessRequests(double seconds)
{
  Internals& state = *this->State;
  if (!relevo::CheckRange(this, "The time of ProcessRequests()", seconds, 0.0, LongestWait))
  {
    return this->IsRunning();
  }
  // Observers of events can call this, too.
  if (!state.Server || state.IsProcessing)
  {
    return this->IsRunning();
  }
  const vtkSmartPointer<vtkWindowServer> self(this); // observers can delete it
  const ServerClock::time_point end = ServerClock::now() + ToDuration(seconds);
  state.IsProcessing = true;
  while (state.Server)
  {
    this->HandleMessages();
    this->UpdatePicture();
    if (!state.Server || ServerClock::now() >= end)
    {
      break;
    }
    state.Messages.WaitUntil(state.GetNextTime(end, this->StillDelay));
  }
  state.IsProcessing = false;
  return this->IsRunning();
}

//------------------------------------------------------------------------------
void vtkWindowServer::Stop()
{
  Internals& state = *this->State;
  state.Encoder.reset();
  state.Server.reset();
  state.URL.clear();
  if (state.Window && state.Window->GetInteractor())
  {
    state.Player.ReleaseAll(state.Window);
  }
}

//------------------------------------------------------------------------------
bool vtkWindowServer::IsRunning()
{
  return this->State->Server != nullptr;
}

//------------------------------------------------------------------------------
int vtkWindowServer::GetNumberOfClients()
{
  return this->State->Server ? this->State->Server->GetNumberOfClients() : 0;
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkWindowServer::GetNumberOfPictures()
{
  return this->State->NumberOfPictures;
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkWindowServer::GetNumberOfReadFrames()
{
  return this->State->NumberOfReadFrames;
}

//------------------------------------------------------------------------------
void vtkWindowServer::OnFrame()
{
  Internals& state = *this->State;
  ++state.Frame;
  state.FrameTime = ServerClock::now();
  std::copy_n(state.Window->GetSize(), 2, state.FrameSize.begin());
  if (state.Encoder)
  {
    state.Encoder->CancelLossless();
  }
}

//------------------------------------------------------------------------------
void vtkWindowServer::HandleMessages()
{
  Internals& state = *this->State;
  const std::vector<relevo::Inbox::Entry> entries = state.Messages.Take();
  for (const std::string& warning : state.Messages.TakeWarnings())
  {
    vtkWarningMacro(<< warning);
  }
  const vtkSmartPointer<vtkRenderWindow> window = state.Window;
  const vtkSmartPointer<vtkRenderWindowInteractor> interactor =
    window ? window->GetInteractor() : nullptr;
  if (!interactor)
  {
    return;
  }
  bool isNeeded = false;
  {
    const relevo::FrameRequests requests(interactor);
    isNeeded = state.Player.Play(window, entries, this->AllowResizing);
    if (state.Interactor)
    {
      state.Interactor->FireTimers(ServerClock::now());
    }
    isNeeded = isNeeded || requests.IsRequested();
  }
  if (isNeeded && window == state.Window)
  {
    window->Render();
  }
}

//------------------------------------------------------------------------------
void vtkWindowServer::UpdatePicture()
{
  Internals& state = *this->State;
  if (!state.Server || !state.Window || state.Server->GetNumberOfClients() == 0)
  {
    return;
  }
  const int* size = state.Window->GetSize();
  const bool isKnown = state.FrameSize[0] > 0;
  if (isKnown ? !std::equal(size, size + 2, state.FrameSize.begin())
              : state.Window->GetNeverRendered() != 0)
  {
    state.Window->Render();
  }
  else if (!isKnown)
  {
    ++state.Frame; // drawn before the server observed the window
    std::copy_n(size, 2, state.FrameSize.begin());
  }
  if (state.Server && state.Encoder->IsIdle() && state.Window)
  {
    const bool isStill = state.IsStill(this->StillDelay);
    if (state.Server->IsWanted(state.Frame, isStill))
    {
      this->ReadPicture(isStill);
    }
  }
}

//------------------------------------------------------------------------------
void vtkWindowServer::ReadPicture(bool isStill)
{
  Internals& state = *this->State;
  const int width = state.FrameSize[0];
  const int height = state.FrameSize[1];
  const int isFront = 1;
  state.Window->GetPixelData(0, 0, width - 1, height - 1, isFront, state.Pixels);
  relevo::RawPicture& picture = state.Encoder->GetPicture();
  const vtkIdType bytes = static_cast<vtkIdType>(width) * height * 3;
  if (state.Pixels->GetNumberOfValues() != bytes)
  {
    return; // the window has reported the error
  }
  picture.Width = width;
  picture.Height = height;
  picture.Frame = state.Frame;
  picture.IsLossless = isStill;
  picture.Pixels.assign(state.Pixels->GetPointer(0), state.Pixels->GetPointer(0) + bytes);
  ++state.NumberOfReadFrames;
  state.Encoder->Start(this->JPEGQuality);
}
