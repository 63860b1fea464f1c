// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   EventPlayer
 * @brief   gives messages of clients to the interactor of a window
 */
#ifndef EventPlayer_h
#define EventPlayer_h

#include "Messages/ClientMessage.h"
#include "Messages/Inbox.h"

#include <map>
#include <set>
#include <vector>

class vtkRenderWindow;
class vtkRenderWindowInteractor;

namespace relevo
{
class EventPlayer
{
public:
  /// Invokes the events of all messages. Returns whether the window has a new size.
  bool Play(vtkRenderWindow* window, const std::vector<Inbox::Entry>& entries, bool canResize);

  /// Releases the buttons that clients hold.
  void ReleaseAll(vtkRenderWindow* window);

private:
  void PlayOne(vtkRenderWindow* window, int client, const ClientMessage& message);
  void Press(vtkRenderWindow* window, int client, const ClientMessage& message);
  void Release(vtkRenderWindow* window, int client, const ClientMessage& message);
  void ReleaseButtons(vtkRenderWindow* window, int client);
  static void PressKey(vtkRenderWindowInteractor* interactor, const ClientMessage& message);
  bool Resize(vtkRenderWindow* window, const ClientMessage& message);

  std::map<int, std::set<int>> Pressed; // buttons of each client
  int Dots = 0;                         // DPI of the window before a client changed it
};
}

#endif
