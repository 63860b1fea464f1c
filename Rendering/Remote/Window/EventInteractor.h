// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   EventInteractor
 * @brief   an interactor that gets all events from a program, with timers
 *
 * For off-screen windows, which have no events of their own.
 */
#ifndef EventInteractor_h
#define EventInteractor_h

#include "vtkRenderWindowInteractor.h"

#include <chrono>
#include <map>
#include <optional>

namespace relevo
{
class EventInteractor : public vtkRenderWindowInteractor
{
public:
  using Time = std::chrono::steady_clock::time_point;

  static EventInteractor* New();
  vtkTypeMacro(EventInteractor, vtkRenderWindowInteractor);

  /// Enables the interactor without a frame.
  void Initialize() override;
  /// Events come from the server, so the interactor does not wait for any.
  void Start() override;
  void ProcessEvents() override;
  void TerminateApp() override;

  /// Invokes a TimerEvent for each timer that is due.
  void FireTimers(const Time& now);
  /// When the next timer is due.
  std::optional<Time> GetNextTimer() const;

protected:
  EventInteractor();
  ~EventInteractor() override;

  int InternalCreateTimer(int id, int type, unsigned long duration) override;
  int InternalDestroyTimer(int platformId) override;

private:
  EventInteractor(const EventInteractor&) = delete;
  void operator=(const EventInteractor&) = delete;

  struct Timer
  {
    int Id; // that of VTK
    Time End;
    std::chrono::milliseconds Period; // 0 for a timer that fires once
  };
  std::map<int, Timer> Timers;
  int LastTimer = 0;
};
}

#endif
