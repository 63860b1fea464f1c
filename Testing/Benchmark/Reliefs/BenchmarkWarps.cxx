// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkWarps.h"

#include "BenchmarkMeasure.h"
#include "BenchmarkReport.h"
#include "RelevoWarpScenes.h"
#include "vtkReliefWarper.h"

#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkNew.h"

#include <chrono>
#include <cmath>
#include <iostream>
#include <limits>
#include <string>
#include <thread>
#include <vector>

namespace
{
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

// Depths in widths of the picture, at places from -0.5 to 0.5.
struct Sample
{
  const char* Name;
  double (*Depth)(double x, double y);
  double Published; // multi-threaded to sequential
};

double GetTerrain(double x, double y)
{
  const double height = 0.04 * std::sin(19.0 * x) * std::cos(17.0 * y) +
    0.01 * std::sin(71.0 * x + 13.0 * y) + 0.005 * std::cos(151.0 * y - 37.0 * x);
  const bool isVoid = std::hypot(x - 0.21, y + 0.17) < 0.04;
  return isVoid ? NaN : 0.07 + height;
}

// Of 9 x 9 columns with round heads in front of a wall that is open here and there.
double GetColumns(double x, double y)
{
  const double across = 9.0 * x - std::floor(9.0 * x) - 0.5;
  const double up = 9.0 * y - std::floor(9.0 * y) - 0.5;
  const double squared = 0.16 - across * across - up * up;
  if (squared > 0.0)
  {
    return 0.09 - 0.2 * std::sqrt(squared);
  }
  return across * across + up * up > 0.36 ? NaN : 0.12;
}

// A bumpy object that fills 54 % of the picture.
double GetObject(double x, double y)
{
  const double squared = 0.172 - x * x - y * y;
  return squared > 0.0
    ? 0.3 - 0.6 * std::sqrt(squared) + 0.01 * std::sin(40.0 * x) * std::sin(37.0 * y)
    : NaN;
}

constexpr Sample Samples[] = { { "terrain with a void", GetTerrain, 1.37 },
  { "columns before a wall", GetColumns, 1.25 }, { "object", GetObject, 0.90 } };

// Around the middle of the relief, some 15 to 20 degrees aside.
void MoveCamera(vtkCamera* camera, int size, int step)
{
  const double middle = 0.5 * (size - 1);
  camera->SetFocalPoint(middle, middle, 0.0);
  camera->SetPosition(middle + 0.7 * size * std::sin(0.7 * step),
    middle + 0.55 * size * std::cos(0.7 * step), -2.0 * size);
}

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

void AddSample(const Sample& sample, int size, int rounds, BenchmarkTable& table)
{
  const auto image =
    RelevoMakeRelief(size, size, relevo::ReliefProjection::Parallel, relevo::dmat4(1.0),
      [&](int column, int row)
      { return size * sample.Depth((column + 0.5) / size - 0.5, (row + 0.5) / size - 0.5); });
  RelevoAddWarpNormals(image);
  relevo::Relief relief;
  relief.Read(image);
  const double invalid =
    1.0 - static_cast<double>(relief.GetNumberOfValidTexels()) / relief.GetNumberOfTexels();

  vtkNew<vtkCamera> camera;
  vtkNew<vtkReliefWarper> warpers[4];
  Times times[4];
  for (int round = -1; round < rounds; ++round) // the first reads the relief
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
  for (const Sample& sample : Samples)
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
