// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkMeasure.h"

#include <algorithm>
#include <ctime>
#include <fstream>
#include <limits>
#include <string>

double GetProcessorSeconds()
{
#ifdef CLOCK_PROCESS_CPUTIME_ID
  timespec time;
  if (clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time) == 0)
  {
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  }
#endif
  return std::numeric_limits<double>::quiet_NaN();
}

double GetMedian(std::vector<double> values)
{
  if (values.empty())
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  std::sort(values.begin(), values.end());
  return 0.5 * (values[(values.size() - 1) / 2] + values[values.size() / 2]);
}

double GetMedianRatio(const std::vector<double>& values, const std::vector<double>& references)
{
  std::vector<double> ratios(std::min(values.size(), references.size()));
  for (size_t i = 0; i < ratios.size(); ++i)
  {
    ratios[i] = values[i] / references[i];
  }
  return GetMedian(ratios);
}

ResidentMemory GetResidentMemory()
{
  const double unknown = std::numeric_limits<double>::quiet_NaN();
  ResidentMemory memory{ unknown, unknown };
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
  {
    const size_t value = line.find(':') + 1;
    if (line.compare(0, 6, "VmRSS:") == 0)
    {
      memory.Current = 1024.0 * std::stod(line.substr(value));
    }
    else if (line.compare(0, 6, "VmHWM:") == 0)
    {
      memory.Peak = 1024.0 * std::stod(line.substr(value));
    }
  }
  return memory;
}
