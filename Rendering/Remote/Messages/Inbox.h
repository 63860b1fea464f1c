// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   Inbox
 * @brief   passes messages of clients from their threads to the thread of the window
 *
 * Moves of the mouse that follow each other become one. If messages arrive faster than the window
 * handles them, the threads of the clients wait, so memory is limited and nothing is lost.
 */
#ifndef Inbox_h
#define Inbox_h

#include "Messages/ClientMessage.h"

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <vector>

namespace relevo
{
class Inbox
{
public:
  using Time = std::chrono::steady_clock::time_point;

  struct Entry
  {
    int Client = 0;
    ClientMessage Message;
  };

  /// Appends a message. Waits for space unless the inbox is closed; then the message is dropped.
  void Put(int client, const ClientMessage& message);
  /// Stores a text for the user. The first ones since the last TakeWarnings() are kept.
  void Warn(const std::string& text);
  /// Ends the waiting of the window's thread, because something else has changed.
  void Wake();

  std::vector<Entry> Take();
  std::vector<std::string> TakeWarnings();
  /// Waits for a message, for Wake(), or until this time.
  void WaitUntil(const Time& end);

  void Open();
  void Close();

private:
  std::mutex Mutex;
  std::condition_variable Filled;
  std::condition_variable Emptied;
  std::vector<Entry> Entries;
  std::vector<std::string> Warnings;
  bool IsAwake = false;
  bool IsOpen = false;
};
}

#endif
