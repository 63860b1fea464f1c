// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Frames of a drag become shorter while events wait for them, so that the last frame comes soon
// after the last event. Times are those of a simulated interactor.
#include "RelevoCheck.h"
#include "View/EventPace.h"

#include <algorithm>
#include <cmath>

namespace
{
constexpr double WholeTime = 0.8; // of a frame with all rays, in seconds

// Drags with an event each `interval`. All events are drawn, in order. Returns the delay of the
// last frame after its event, in seconds, and the factor at the end.
double Drag(relevo::EventPace& pace, double interval, int events, double allotted)
{
  double now = 100.0;
  const double begin = now;
  for (int i = 0; i < events; ++i)
  {
    now = std::max(now, begin + interval * i);
    pace.Begin(true, now);
    now += std::min(WholeTime, pace.GetFactor() * allotted);
    pace.End(true, now);
  }
  return now - (begin + interval * (events - 1));
}

// With 60 events per second and a frame time of 67 ms, frames would end 5 s late without a pace.
void TestSettles(RelevoCheck& check)
{
  relevo::EventPace pace;
  CHECK_EQUAL(pace.GetFactor(), 1.0);
  const double late = Drag(pace, 1.0 / 60.0, 120, 1.0 / 15.0);
  CHECK_LESS(late, 2.0 / 15.0);
  CHECK_LESS(pace.GetFactor(), 0.5);
  // The still frame after the drag has all its time.
  pace.Begin(false, 200.0);
  CHECK_EQUAL(pace.GetFactor(), 1.0);
  pace.End(false, 201.0);
  // The first frame of the next drag does not count as late, however soon it follows.
  pace.Begin(true, 201.0);
  CHECK_EQUAL(pace.GetFactor(), 1.0);
}

// Rare events leave the frames as they are.
void TestRareEvents(RelevoCheck& check)
{
  relevo::EventPace pace;
  Drag(pace, 0.2, 30, 1.0 / 15.0);
  CHECK_EQUAL(pace.GetFactor(), 1.0);
}

// Frames become longer again when events no longer wait, and never shorter than 1/64.
void TestRange(RelevoCheck& check)
{
  relevo::EventPace pace;
  Drag(pace, 0.0, 40, 1.0 / 15.0);
  CHECK_EQUAL(pace.GetFactor(), 1.0 / 64.0);
  double time = 300.0;
  for (int i = 0; i < 30; ++i)
  {
    pace.Begin(true, time += 1.0);
    pace.End(true, time += 0.01);
  }
  CHECK_EQUAL(pace.GetFactor(), 1.0);
}
}

int TestEventPace(int, char*[])
{
  RelevoCheck check;
  TestSettles(check);
  TestRareEvents(check);
  TestRange(check);
  return check.GetResult();
}
