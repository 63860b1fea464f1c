// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef StopObserver_h
#define StopObserver_h

#include <vtkCommand.h>
#include <vtkPython.h> // before standard headers

#include <atomic>
#include <chrono>

namespace relevo
{
/**
 * @class   StopObserver
 * @brief   Asks Python whether work must stop, and aborts the caller of the event if it must.
 *
 * Events come while the thread does not hold Python's lock. The observer takes the lock at most
 * every 50 ms, because other threads can keep it for milliseconds.
 */
class StopObserver : public vtkCommand
{
public:
  vtkTypeMacro(StopObserver, vtkCommand);
  static StopObserver* New() { return new StopObserver; }

  /// Set the function of Python that returns whether to stop. The observer borrows it.
  void SetQuestion(PyObject* question) { this->Question = question; }

  void Execute(vtkObject* caller, unsigned long event, void* data) override;

  /// Return whether the question was answered by yes or by an exception.
  bool IsStopped() const { return this->Stopped; }

protected:
  StopObserver() = default;
  ~StopObserver() override = default;

private:
  void Ask();

  PyObject* Question = nullptr;
  std::atomic<bool> Stopped{ false };
  std::chrono::steady_clock::time_point Next = std::chrono::steady_clock::now();
};
}

#endif
