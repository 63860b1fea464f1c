// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   WarpWorker
 * @brief   a thread that executes tasks in order, and sleeps between them
 *
 * All functions must be called from the same thread. Private to the module.
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
  /// Waits for the current task.
  ~WarpWorker();
  WarpWorker(const WarpWorker&) = delete;
  void operator=(const WarpWorker&) = delete;

  /// Executes a task after the current one. It must not throw.
  void Start(std::function<void()> work);
  void Wait() const;

private:
  void Live();

  mutable std::mutex Mutex;
  mutable std::condition_variable Changed;
  std::function<void()> Work; // empty without a task
  bool IsToEnd = false;
  std::thread Thread;
};
}

#endif
