// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   WarpWorker
 * @brief   a thread that does one thing after the other, and sleeps in between
 *
 * All but the work itself is called by one thread. Private to the module's own sources.
 */
#ifndef WarpWorker_h
#define WarpWorker_h

#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>

namespace relevo
{
class WarpWorker
{
public:
  WarpWorker() = default;
  /// Waits for the work at hand.
  ~WarpWorker();
  WarpWorker(const WarpWorker&) = delete;
  void operator=(const WarpWorker&) = delete;

  /// Work that throws nothing, as soon as what is at hand is done.
  void Start(std::function<void()> work);
  void Wait() const;

private:
  void Live();

  mutable std::mutex Mutex;
  mutable std::condition_variable Changed;
  std::function<void()> Work; // while there is some
  bool IsToEnd = false;
  std::thread Thread;
};
}

#endif
