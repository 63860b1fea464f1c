// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   work that may crash or hang, item by item in a process of its own
 */
#ifndef BenchmarkWorker_h
#define BenchmarkWorker_h

#include <array>
#include <functional>

struct BenchmarkWorker
{
  using Figures = std::array<double, 6>;

  /// Does the items 0 to number - 1, each by a call that returns figures. They run one after the
  /// other in a child process; after a crash, or an item that takes longer than so many seconds,
  /// another child goes on with the next one. The calling process must have no threads.
  BenchmarkWorker(int number, unsigned int seconds, const std::function<Figures(int)>& work);

  Figures Sums{}; // over the items that were finished
  int Finished = 0;
  int Crashes = 0;
  int Hangs = 0;
};

#endif
