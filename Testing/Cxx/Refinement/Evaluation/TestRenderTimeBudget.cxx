// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves guide.md on budgets: relevo::RenderTimeBudget keeps the frame time close to the allotted
// time, tested with simulated machines of known frame times.
#include "RelevoCheck.h"

#include "Evaluation/RenderTimeBudget.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace
{
// Simulates frames of a scene with this many triangles, or fewer if the budget limits them.
class Machine
{
public:
  double Fixed = 0.0;        // seconds per frame
  double PerTriangle = 1e-7; // seconds
  double Noise = 0.0;        // a share of the time
  int Hiccup = 0;            // every so many frames, one takes ten times as long
  vtkIdType Scene = 1000000;

  void Draw(double allowed)
  {
    this->Limit = this->Budget.FindLimit(allowed, this->Limit);
    this->Triangles = this->Limit > 0 ? std::min(this->Limit, this->Scene) : this->Scene;
    this->Seconds = this->Fixed + this->PerTriangle * static_cast<double>(this->Triangles);
    std::uniform_real_distribution<double> noise(1.0 - this->Noise, 1.0 + this->Noise);
    ++this->Frame;
    const bool isHiccup = this->Hiccup > 0 && this->Frame % this->Hiccup == 0;
    this->Budget.AddFrame(
      this->Triangles, this->Seconds * noise(this->Random) * (isHiccup ? 10.0 : 1.0));
  }

  relevo::RenderTimeBudget Budget;
  vtkIdType Limit = 0;
  vtkIdType Triangles = 0;
  double Seconds = 0.0; // frame time without noise

private:
  int Frame = 0;
  std::mt19937 Random{ 5 };
};

void TestEnoughTime(RelevoCheck& check)
{
  Machine machine;
  for (int i = 0; i < 20; ++i)
  {
    machine.Draw(0.11); // the frame needs 0.1
    CHECK_EQUAL(machine.Limit, 0);
  }
  CHECK_NEAR(machine.Budget.GetSecondsPerTriangle(), 1e-7, 1e-12);
}

// It settles within a few frames below the allowed time and stays there. Full detail returns at
// once when time allows.
void TestSettling(RelevoCheck& check, Machine machine)
{
  for (const double allowed : { 0.05, 0.02 })
  {
    CHECK_CASE(allowed);
    for (int i = 0; i < 30; ++i)
    {
      machine.Draw(allowed);
    }
    const vtkIdType settled = machine.Triangles;
    CHECK_LESS(machine.Seconds, 1.1 * allowed);
    CHECK_GREATER(machine.Seconds, 0.5 * allowed);
    for (int i = 0; i < 200; ++i)
    {
      machine.Draw(allowed);
      CHECK_EQUAL(machine.Triangles, settled);
    }
  }
  machine.Draw(10000.0);
  CHECK_EQUAL(machine.Limit, 0);
  CHECK_EQUAL(machine.Triangles, machine.Scene);
}

// It approaches without oscillation: if there are too many triangles, their number only falls.
void TestOneWay(RelevoCheck& check)
{
  for (const double fixed : { 0.0, 0.01, 0.03, 0.045 })
  {
    Machine machine;
    machine.Fixed = fixed;
    vtkIdType last = machine.Scene;
    for (int i = 0; i < 100; ++i)
    {
      machine.Draw(0.05);
      CHECK_LESS_EQUAL(machine.Triangles, last);
      last = machine.Triangles;
    }
    CHECK_LESS_EQUAL(machine.Seconds, 0.05);
    // If there is time to spare, their number only rises.
    for (int i = 0; i < 100; ++i)
    {
      machine.Draw(0.09);
      CHECK_GREATER_EQUAL(machine.Triangles, last);
      last = machine.Triangles;
    }
    CHECK_LESS_EQUAL(machine.Seconds, 0.09);
  }
}

// If the time is too short for any number of triangles, it draws as few as possible, and recovers.
void TestTooLittleTime(RelevoCheck& check)
{
  Machine machine;
  machine.Fixed = 0.02;
  for (int i = 0; i < 300; ++i)
  {
    machine.Draw(0.01);
    CHECK_GREATER_EQUAL(machine.Triangles, 1);
  }
  CHECK_LESS(machine.Triangles, 1000);
  machine.Draw(10000.0);
  CHECK_EQUAL(machine.Triangles, machine.Scene);
}

void TestNonsense(RelevoCheck& check)
{
  relevo::RenderTimeBudget budget;
  CHECK_EQUAL(budget.FindLimit(0.1, 0), 0);
  CHECK_EQUAL(budget.FindLimit(0.1, 77), 77); // without measurements, the number stays
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 5; ++i)
  {
    budget.AddFrame(0, 1.0);
    budget.AddFrame(-5, 1.0);
    budget.AddFrame(100, nan);
    budget.AddFrame(100, infinity);
    budget.AddFrame(100, 0.0);
    budget.AddFrame(100, -1.0);
  }
  CHECK_EQUAL(budget.GetSecondsPerTriangle(), 0.0);
  for (int i = 0; i < 5; ++i)
  {
    budget.AddFrame(1000, 1.0);
  }
  CHECK_EQUAL(budget.FindLimit(nan, 5), 5);
  CHECK_EQUAL(budget.FindLimit(0.0, 5), 5);
  CHECK_EQUAL(budget.FindLimit(-1.0, 5), 5);
  CHECK_EQUAL(budget.FindLimit(infinity, 5), 0);
  CHECK_EQUAL(budget.FindLimit(0.5, 0), 425);
}
}

int TestRenderTimeBudget(int, char*[])
{
  RelevoCheck check;
  TestEnoughTime(check);
  TestSettling(check, Machine());
  Machine machine;
  machine.Noise = 0.1;
  TestSettling(check, machine);
  machine.Hiccup = 7;
  TestSettling(check, machine);
  machine.Fixed = 0.005;
  TestSettling(check, machine);
  TestOneWay(check);
  TestTooLittleTime(check);
  TestNonsense(check);
  return check.GetResult();
}
