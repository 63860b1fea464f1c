// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   runs work that may crash or hang, item by item, in a separate process
 */
#ifndef BenchmarkWorker_h
#define BenchmarkWorker_h

#include <array>
#include <functional>

struct BenchmarkWorker
{
  using Figures = std::array<double, 6>;

  /// Runs the items 0 to number - 1 by calls that return figures, one after the other in a child
  /// process. After a crash, or after an item takes longer than `seconds`, another child continues
  /// with the next item. The calling process must not have threads.
  BenchmarkWorker(int number, unsigned int seconds, const std::function<Figures(int)>& work);

  Figures Sums{}; // over the completed items
  int Finished = 0;
  int Crashes = 0;
  int Hangs = 0;
};

#endif
