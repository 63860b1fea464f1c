// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Connection/ClientConnection.h"

#include <utility>

namespace relevo
{
namespace
{
const int LargestNumberOfUnconfirmed = 2;
}

//------------------------------------------------------------------------------
ClientConnection::ClientConnection(int number, Sender send)
  : Number(number)
  , SendData(std::move(send))
  , Thread([this] { this->Run(); })
{
}

//------------------------------------------------------------------------------
ClientConnection::~ClientConnection()
{
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->IsEnding = true;
  }
  this->Changed.notify_one();
  this->Thread.join();
}

//------------------------------------------------------------------------------
bool ClientConnection::CanTake(std::uint64_t frame, bool isLossless) const
{
  const bool isNew =
    this->Frame < frame || (this->Frame == frame && isLossless && !this->IsLossless);
  return isNew && !this->Waiting && this->NumberOfUnconfirmed < LargestNumberOfUnconfirmed &&
    !this->IsLeaving && !this->IsEnding;
}

//------------------------------------------------------------------------------
bool ClientConnection::Wants(std::uint64_t frame, bool isLossless) const
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  return this->CanTake(frame, isLossless);
}

//------------------------------------------------------------------------------
bool ClientConnection::Lacks(std::uint64_t frame) const
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  return this->Frame < frame || !this->IsLossless;
}

//------------------------------------------------------------------------------
bool ClientConnection::Send(const std::shared_ptr<const EncodedPicture>& picture)
{
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    if (!this->CanTake(picture->Frame, picture->IsLossless))
    {
      return false;
    }
    this->Waiting = picture;
    this->Frame = picture->Frame;
    this->IsLossless = picture->IsLossless;
    ++this->NumberOfUnconfirmed;
  }
  this->Changed.notify_one();
  return true;
}

//------------------------------------------------------------------------------
void ClientConnection::Confirm()
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  if (this->NumberOfUnconfirmed > 0)
  {
    --this->NumberOfUnconfirmed;
  }
}

//------------------------------------------------------------------------------
void ClientConnection::Leave()
{
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->IsLeaving = true;
  }
  this->Changed.notify_one();
}

//------------------------------------------------------------------------------
void ClientConnection::Run()
{
  for (;;)
  {
    std::shared_ptr<const EncodedPicture> picture;
    {
      std::unique_lock<std::mutex> lock(this->Mutex);
      this->Changed.wait(
        lock, [this] { return this->Waiting || this->IsLeaving || this->IsEnding; });
      if (this->IsEnding)
      {
        return;
      }
      picture = std::exchange(this->Waiting, nullptr);
    }
    const bool isSent =
      this->SendData(picture ? picture->Data.data() : nullptr, picture ? picture->Data.size() : 0);
    this->Broken = !isSent;
    if (!isSent || !picture)
    {
      return; // the thread that reads ends the connection
    }
  }
}
}
