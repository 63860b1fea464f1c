// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Warp/WarpWorker.h"

#include <utility>

namespace relevo
{
WarpWorker::~WarpWorker()
{
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->IsToEnd = true;
  }
  this->Changed.notify_all();
  if (this->Thread.joinable())
  {
    this->Thread.join();
  }
}

void WarpWorker::Start(std::function<void()> work)
{
  this->Wait();
  if (!this->Thread.joinable())
  {
    this->Thread = std::thread([this] { this->Live(); });
  }
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Work = std::move(work);
  }
  this->Changed.notify_all();
}

void WarpWorker::Wait() const
{
  std::unique_lock<std::mutex> lock(this->Mutex);
  this->Changed.wait(lock, [this] { return !this->Work; });
}

void WarpWorker::Live()
{
  std::unique_lock<std::mutex> lock(this->Mutex);
  for (;;)
  {
    this->Changed.wait(lock, [this] { return this->IsToEnd || this->Work; });
    if (this->Work)
    {
      const std::function<void()> work = this->Work;
      lock.unlock();
      work();
      lock.lock();
      this->Work = nullptr;
      this->Changed.notify_all();
    }
    if (this->IsToEnd)
    {
      return;
    }
  }
}
}
