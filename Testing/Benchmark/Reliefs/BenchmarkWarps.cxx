// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkWarps.h"

#include "BenchmarkMeasure.h"
#include "BenchmarkReport.h"
#include "BenchmarkWarpSamples.h"
#include "Data/Relief.h"
#include "vtkReliefWarper.h"

#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkNew.h"

#include <chrono>
#include <iostream>
#include <limits>
#include <string>
#include <thread>
#include <vector>

namespace
{
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

void WarpOnce(vtkReliefWarper* warper)
{
  warper->Update();
  while (warper->GetState() == vtkReliefWarper::WARPING)
  {
    std::this_thread::sleep_for(std::chrono::microseconds(50));
  }
  warper->Update();
}

struct Times
{
  std::vector<double> Seconds;
  std::vector<double> Processor;
};

const char* const Names[] = { "sequential", "parallel", "multi-threaded", "rows and columns" };

void AddSample(const BenchmarkWarpSample& sample, int size, int rounds, BenchmarkTable& table)
{
  const auto image = MakeRelief(sample, size);
  relevo::Relief relief;
  relief.Read(image);
  const double invalid =
    1.0 - static_cast<double>(relief.GetNumberOfValidTexels()) / relief.GetNumberOfTexels();

  vtkNew<vtkCamera> camera;
  vtkNew<vtkReliefWarper> warpers[4];
  Times times[4];
  for (int round = -1; round < rounds; ++round) // the first round reads the relief
  {
    MoveCamera(camera, size, round);
    for (int policy = 0; policy < 4; ++policy)
    {
      vtkReliefWarper* warper = warpers[policy];
      warper->SetInputData(image);
      warper->SetCamera(camera);
      warper->SetPolicy(policy);
      const double processor = GetProcessorSeconds();
      const Stopwatch stopwatch;
      WarpOnce(warper);
      if (round >= 0)
      {
        times[policy].Seconds.push_back(stopwatch.GetSeconds());
        times[policy].Processor.push_back(GetProcessorSeconds() - processor);
      }
    }
  }
  const double asked[] = { NaN, 0.9, invalid > 0.4 ? 1.4 : 1.6, NaN };
  for (int policy = 0; policy < 4; ++policy)
  {
    table.AddRow({ std::string(sample.Name), static_cast<double>(size), 100.0 * invalid,
      std::string(Names[policy]), 1.0 / GetMedian(times[policy].Seconds),
      GetMedianRatio(times[0].Seconds, times[policy].Seconds),
      GetMedianRatio(times[policy].Processor, times[0].Processor),
      size == 1024 ? asked[policy] : NaN,
      policy == vtkReliefWarper::MULTI_THREADED ? sample.Published : NaN });
  }
}
}

void AddWarps(const BenchmarkOptions& options, const AddTable& addTable)
{
  BenchmarkTable table("relief-warps", "Warps of reliefs, by the policies of vtkReliefWarper",
    { { "sample", "sample", 0 }, { "texels", "texels a side", 0 },
      { "invalid_percent", "without surface, %", 1 }, { "policy", "policy", 0 },
      { "warps", "warps/s", 1 }, { "ratio_sequential", "to sequential", 2 },
      { "ratio_processor", "processor time to sequential's", 2 }, { "ratio_asked", "asked", 2 },
      { "ratio_published", "published", 2 } });
  for (const BenchmarkWarpSample& sample : GetWarpSamples())
  {
    for (int size : { 256, 1024 })
    {
      if (options.Quick && size > 256)
      {
        continue;
      }
      std::cerr << "relief: warps of " << sample.Name << ", " << size << std::endl;
      AddSample(sample, size, options.Quick ? 2 : (options.Full ? 101 : 31), table);
    }
  }
  table.AddNote("The camera moves from warp to warp. Two threads take at best half of their "
                "processor time.");
  addTable(table);
}
