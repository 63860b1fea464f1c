// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   clock, statistics and the process's own memory
 */
#ifndef BenchmarkMeasure_h
#define BenchmarkMeasure_h

#include <chrono>
#include <vector>

class Stopwatch
{
public:
  double GetSeconds() const
  {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - this->Start).count();
  }

private:
  std::chrono::steady_clock::time_point Start = std::chrono::steady_clock::now();
};

/// Seconds that all cores together have spent on this process: what other programs do on them
/// hardly counts. NaN where the system does not tell.
double GetProcessorSeconds();

/// NaN for no values.
double GetMedian(std::vector<double> values);

/// Median of values[i] / references[i], as far as there are both: what was measured one after the
/// other is compared.
double GetMedianRatio(const std::vector<double>& values, const std::vector<double>& references);

struct ResidentMemory
{
  double Current = 0.0; // bytes
  double Peak = 0.0;
};
/// Of this process, from Linux's /proc; NaN elsewhere.
ResidentMemory GetResidentMemory();

#endif
