// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   clock, statistics and memory of the process
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

/// Seconds that all cores have spent on this process, which other programs hardly affect. NaN if
/// the system does not provide it.
double GetProcessorSeconds();

/// NaN without values.
double GetMedian(std::vector<double> values);

/// Median of values[i] / references[i] over their common length: compares measurements made one
/// after the other.
double GetMedianRatio(const std::vector<double>& values, const std::vector<double>& references);

struct ResidentMemory
{
  double Current = 0.0; // bytes
  double Peak = 0.0;
};
/// Memory of this process from Linux's /proc; NaN on other systems.
ResidentMemory GetResidentMemory();

#endif
