// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Messages/Inbox.h"

#include <utility>

namespace relevo
{
namespace
{
const std::size_t LargestNumberOfEntries = 1024;
const std::size_t LargestNumberOfWarnings = 16;

bool CanReplace(const Inbox::Entry& old, int client, const ClientMessage& message)
{
  using Type = ClientMessage::Type;
  return old.Client == client && old.Message.What == message.What &&
    (message.What == Type::Resize ||
      (message.What == Type::Move && old.Message.Modifiers == message.Modifiers));
}
}

//------------------------------------------------------------------------------
void Inbox::Put(int client, const ClientMessage& message)
{
  std::unique_lock<std::mutex> lock(this->Mutex);
  if (!this->Entries.empty() && CanReplace(this->Entries.back(), client, message))
  {
    this->Entries.back().Message = message;
    return;
  }
  this->Emptied.wait(
    lock, [this] { return !this->IsOpen || this->Entries.size() < LargestNumberOfEntries; });
  if (this->IsOpen)
  {
    this->Entries.push_back({ client, message });
    this->IsAwake = true;
    this->Filled.notify_one();
  }
}

//------------------------------------------------------------------------------
void Inbox::Warn(const std::string& text)
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  if (this->Warnings.size() < LargestNumberOfWarnings)
  {
    this->Warnings.push_back(text);
  }
  this->IsAwake = true;
  this->Filled.notify_one();
}

//------------------------------------------------------------------------------
void Inbox::Wake()
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  this->IsAwake = true;
  this->Filled.notify_one();
}

//------------------------------------------------------------------------------
std::vector<Inbox::Entry> Inbox::Take()
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  this->IsAwake = false;
  this->Emptied.notify_all();
  return std::exchange(this->Entries, {});
}

//------------------------------------------------------------------------------
std::vector<std::string> Inbox::TakeWarnings()
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  return std::exchange(this->Warnings, {});
}

//------------------------------------------------------------------------------
void Inbox::WaitUntil(const Time& end)
{
  std::unique_lock<std::mutex> lock(this->Mutex);
  this->Filled.wait_until(lock, end, [this] { return this->IsAwake; });
}

//------------------------------------------------------------------------------
void Inbox::Open()
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  this->IsOpen = true;
}

//------------------------------------------------------------------------------
void Inbox::Close()
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  this->IsOpen = false;
  this->Entries.clear();
  this->Emptied.notify_all();
}
}
