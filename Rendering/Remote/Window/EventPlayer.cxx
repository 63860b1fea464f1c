// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Window/EventPlayer.h"

#include "Messages/KeyNames.h"

#include "vtkCommand.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace relevo
{
namespace
{
const unsigned long PressEvents[] = { vtkCommand::LeftButtonPressEvent,
  vtkCommand::MiddleButtonPressEvent, vtkCommand::RightButtonPressEvent };
const unsigned long ReleaseEvents[] = { vtkCommand::LeftButtonReleaseEvent,
  vtkCommand::MiddleButtonReleaseEvent, vtkCommand::RightButtonReleaseEvent };
const unsigned long DoubleClickEvents[] = { vtkCommand::LeftButtonDoubleClickEvent,
  vtkCommand::MiddleButtonDoubleClickEvent, vtkCommand::RightButtonDoubleClickEvent };

void SetPosition(vtkRenderWindow* window, const ClientMessage& message)
{
  vtkRenderWindowInteractor* interactor = window->GetInteractor();
  const bool hasControl = (message.Modifiers & ClientMessage::Control) != 0;
  const bool hasShift = (message.Modifiers & ClientMessage::Shift) != 0;
  interactor->SetEventInformation(message.X, window->GetSize()[1] - 1 - message.Y, hasControl,
    hasShift, 0, message.Clicks - 1, nullptr);
  interactor->SetAltKey((message.Modifiers & ClientMessage::Alt) != 0);
}
}

//------------------------------------------------------------------------------
bool EventPlayer::Play(
  vtkRenderWindow* window, const std::vector<Inbox::Entry>& entries, bool canResize)
{
  bool isResized = false;
  for (const Inbox::Entry& entry : entries)
  {
    if (entry.Message.What == ClientMessage::Type::Resize)
    {
      isResized = (canResize && this->Resize(window, entry.Message)) || isResized;
    }
    else
    {
      this->PlayOne(window, entry.Client, entry.Message);
    }
  }
  return isResized;
}

//------------------------------------------------------------------------------
void EventPlayer::ReleaseAll(vtkRenderWindow* window)
{
  while (!this->Pressed.empty())
  {
    this->ReleaseButtons(window, this->Pressed.begin()->first);
  }
}

//------------------------------------------------------------------------------
void EventPlayer::PlayOne(vtkRenderWindow* window, int client, const ClientMessage& message)
{
  using Type = ClientMessage::Type;
  vtkRenderWindowInteractor* interactor = window->GetInteractor();
  switch (message.What)
  {
    case Type::Move:
    case Type::Enter:
    case Type::Leave:
      SetPosition(window, message);
      interactor->InvokeEvent(message.What == Type::Move ? vtkCommand::MouseMoveEvent
          : message.What == Type::Enter                  ? vtkCommand::EnterEvent
                                                         : vtkCommand::LeaveEvent);
      break;
    case Type::Press:
      this->Press(window, client, message);
      break;
    case Type::Release:
      this->Release(window, client, message);
      break;
    case Type::Wheel:
      SetPosition(window, message);
      for (int i = 0; i < std::abs(message.Notches); ++i)
      {
        interactor->InvokeEvent(message.Notches > 0 ? vtkCommand::MouseWheelForwardEvent
                                                    : vtkCommand::MouseWheelBackwardEvent);
      }
      break;
    case Type::KeyDown:
    case Type::KeyUp:
      PressKey(interactor, message);
      break;
    case Type::Gone:
      this->ReleaseButtons(window, client);
      break;
    case Type::Resize:
    case Type::Shown:
      break;
  }
}

//------------------------------------------------------------------------------
void EventPlayer::Press(vtkRenderWindow* window, int client, const ClientMessage& message)
{
  SetPosition(window, message);
  this->Pressed[client].insert(message.Button);
  vtkRenderWindowInteractor* interactor = window->GetInteractor();
  interactor->InvokeEvent(PressEvents[message.Button]);
  if (message.Clicks == 2)
  {
    interactor->InvokeEvent(DoubleClickEvents[message.Button]);
  }
}

//------------------------------------------------------------------------------
void EventPlayer::Release(vtkRenderWindow* window, int client, const ClientMessage& message)
{
  SetPosition(window, message);
  this->Pressed[client].erase(message.Button);
  window->GetInteractor()->InvokeEvent(ReleaseEvents[message.Button]);
}

//------------------------------------------------------------------------------
void EventPlayer::ReleaseButtons(vtkRenderWindow* window, int client)
{
  const auto held = this->Pressed.find(client);
  if (held == this->Pressed.end())
  {
    return;
  }
  const std::set<int> buttons = held->second;
  this->Pressed.erase(held);
  for (const int button : buttons)
  {
    window->GetInteractor()->InvokeEvent(ReleaseEvents[button]);
  }
}

//------------------------------------------------------------------------------
void EventPlayer::PressKey(vtkRenderWindowInteractor* interactor, const ClientMessage& message)
{
  const bool hasControl = (message.Modifiers & ClientMessage::Control) != 0;
  const bool hasShift = (message.Modifiers & ClientMessage::Shift) != 0;
  const WindowKey key = FindKey(message.Key, hasControl);
  interactor->SetKeyEventInformation(hasControl, hasShift, key.Code, 0, key.Symbol.c_str());
  interactor->SetAltKey((message.Modifiers & ClientMessage::Alt) != 0);
  if (message.What == ClientMessage::Type::KeyUp)
  {
    interactor->InvokeEvent(vtkCommand::KeyReleaseEvent);
    return;
  }
  interactor->InvokeEvent(vtkCommand::KeyPressEvent);
  interactor->InvokeEvent(vtkCommand::CharEvent);
}

//------------------------------------------------------------------------------
bool EventPlayer::Resize(vtkRenderWindow* window, const ClientMessage& message)
{
  if (this->Dots == 0)
  {
    this->Dots = window->GetDPI();
  }
  // Lengths in points, such as font sizes, keep their size on screens with small pixels.
  const int dots = std::max(1, static_cast<int>(std::lround(this->Dots * message.Percent / 100.0)));
  const int* size = window->GetSize();
  const bool isNew =
    size[0] != message.Width || size[1] != message.Height || window->GetDPI() != dots;
  if (isNew)
  {
    window->SetDPI(dots);
    window->SetSize(message.Width, message.Height);
    vtkRenderWindowInteractor* interactor = window->GetInteractor();
    interactor->SetSize(message.Width, message.Height);
    interactor->InvokeEvent(vtkCommand::ConfigureEvent);
  }
  return isNew;
}
}
