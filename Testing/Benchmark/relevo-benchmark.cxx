// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
//
// relevo-benchmark [--quick] [--height-map FILE] [--output FILE.json] [NAME...]
#include "BenchmarkReport.h"
#include "BenchmarkView.h"
#include "Benchmarks.h"

#include "vtkVersion.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <thread>
#include <vector>

namespace
{
struct Benchmark
{
  const char* Name;
  void (*Run)(const BenchmarkOptions&, const AddTable&);
};
const std::vector<Benchmark> Benchmarks = { { "static-mesh", RunStaticMesh } };

int ShowUsage()
{
  std::cerr << "usage: relevo-benchmark [--quick] [--height-map FILE] [--output FILE.json] "
               "[NAME...]\nNAME:";
  for (const Benchmark& benchmark : Benchmarks)
  {
    std::cerr << ' ' << benchmark.Name;
  }
  std::cerr << std::endl;
  return 2;
}

std::string GetProcessor()
{
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);)
  {
    if (line.compare(0, 10, "model name") == 0)
    {
      return line.substr(line.find(':') + 2) + ", ";
    }
  }
  return std::string();
}
}

int main(int argc, char* argv[])
{
  BenchmarkOptions options;
  std::string output;
  std::vector<std::string> names;
  for (int i = 1; i < argc; ++i)
  {
    const std::string argument = argv[i];
    if (argument == "--quick")
    {
      options.Quick = true;
    }
    else if (argument == "--height-map" && i + 1 < argc)
    {
      options.HeightMap = argv[++i];
    }
    else if (argument == "--output" && i + 1 < argc)
    {
      output = argv[++i];
    }
    else if (std::any_of(Benchmarks.begin(), Benchmarks.end(),
               [&](const Benchmark& benchmark) { return argument == benchmark.Name; }))
    {
      names.push_back(argument);
    }
    else
    {
      return ShowUsage();
    }
  }

  BenchmarkReport report;
  report.AddFact("OpenGL renderer", BenchmarkView().GetOpenGLRenderer());
  report.AddFact("VTK", vtkVersion::GetVTKVersion());
  report.AddFact("Machine",
    GetProcessor() + std::to_string(std::thread::hardware_concurrency()) + " logical cores");
  report.WriteFacts(std::cout);
  auto addTable = [&](const BenchmarkTable& table) { report.Add(table, std::cout); };
  for (const Benchmark& benchmark : Benchmarks)
  {
    if (names.empty() || std::find(names.begin(), names.end(), benchmark.Name) != names.end())
    {
      benchmark.Run(options, addTable);
    }
  }
  if (!output.empty())
  {
    std::ofstream file(output);
    report.WriteJson(file);
    if (!file.flush())
    {
      std::cerr << "relevo-benchmark: error: cannot write " << output << std::endl;
      return EXIT_FAILURE;
    }
  }
  return EXIT_SUCCESS;
}
