// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
//
// relevo-benchmark [--quick | --full] [--height-map FILE] [--paraview PREFIX]
//   [--output FILE.json] [--] [NAME...]
#include "BenchmarkReport.h"
#include "BenchmarkView.h"
#include "Benchmarks.h"
#include "Files/AtomicFile.h"
#include "Text/PrintableText.h"

#include "vtkVersion.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <iterator>
#include <sstream>
#include <system_error>
#include <thread>
#include <vector>

namespace
{
struct Benchmark
{
  const char* Name;
  void (*Run)(const BenchmarkOptions&, const AddTable&);
  bool NeedsOpenGL = true;
};
const std::vector<Benchmark> Benchmarks = {
  { "static-mesh", RunStaticMesh },
  { "selection", RunSelection },
  { "picking", RunPicking },
  { "flight", RunFlight },
  { "drawing", RunDrawing },
  { "methods", RunMethods },
  { "phong", RunPhong },
  { "quality", RunQuality, false },
  { "rules", RunRules, false },
  { "memory", RunMemory },
  { "dem", RunTerrain },
#ifdef BENCHMARK_HAS_TERRAINS
  { "terrain", RunTerrains },
#endif
  { "lic", RunLIC },
#ifdef BENCHMARK_HAS_VOLUMES
  { "volumes", RunVolumes },
  { "volume-neighbors", RunVolumeNeighbors },
  { "volume-skipping", RunVolumeSkipping },
  { "volume-tasks", RunVolumeTasks },
  { "volume-detail", RunVolumeDetail },
  { "volume-curved", RunVolumeCurved },
  { "volume-twin", RunVolumeTwin },
#endif
#ifdef BENCHMARK_HAS_MICRO_MESHES
  { "micromesh", RunMicroMeshes, false },
  { "micromesh-frames", RunMicroMeshFrames },
#endif
#ifdef BENCHMARK_HAS_RELIEFS
  { "relief", RunReliefs },
#endif
#ifdef BENCHMARK_HAS_PATCHES
  { "patches", RunPatches },
#endif
#ifdef BENCHMARK_HAS_INTERSECTIONS
  { "intersections", RunIntersections },
#endif
#ifdef BENCHMARK_HAS_GOOGLE_BENCHMARK
  { "processor", RunProcessor, false },
#endif
};

struct Measurement
{
  const char* Name;
  std::vector<double> (*Run)(const std::vector<std::string>&);
};
const std::vector<Measurement> Measurements = {
  { "memory", MeasureMemory },
  { "dem", MeasureTerrain },
#ifdef BENCHMARK_HAS_TERRAINS
  { "terrain", MeasureTerrains },
#endif
#ifdef BENCHMARK_HAS_VOLUMES
  { "volumes", MeasureVolumes },
#endif
#ifdef BENCHMARK_HAS_MICRO_MESHES
  { "micromesh", MeasureMicroMeshes },
#endif
#ifdef BENCHMARK_HAS_RELIEFS
  { "relief", MeasureReliefs },
#endif
#ifdef BENCHMARK_HAS_PATCHES
  { "patches", MeasurePatches },
#endif
#ifdef BENCHMARK_HAS_INTERSECTIONS
  { "intersections", MeasureIntersections },
#endif
};

std::string ProgramPath;

// Arguments of a separate process, before those of the measurement.
const std::string MeasureOption = "--measure";

int Measure(const std::vector<std::string>& arguments)
{
  for (const Measurement& measurement : Measurements)
  {
    if (!arguments.empty() && arguments[0] == measurement.Name)
    {
      std::cout << std::setprecision(17);
      for (const double value : measurement.Run({ arguments.begin() + 1, arguments.end() }))
      {
        std::cout << value << '\n';
      }
      return EXIT_SUCCESS;
    }
  }
  return EXIT_FAILURE;
}

void ShowError(const std::string& text)
{
  std::cerr << "relevo-benchmark: error: " << ToPrintable(text) << std::endl;
}

int ShowUsage(const std::string& argument)
{
  if (argument != "--help")
  {
    ShowError("unknown argument '" + argument + "', or one without its value");
  }
  std::cerr << "usage: relevo-benchmark [--quick | --full] [--height-map FILE] "
               "[--paraview PREFIX] [--output FILE.json] [--] [NAME...]\nNAME:";
  for (const Benchmark& benchmark : Benchmarks)
  {
    std::cerr << ' ' << benchmark.Name;
  }
  std::cerr << std::endl;
  return 2;
}

bool IsBenchmark(const std::string& name)
{
  return std::any_of(Benchmarks.begin(), Benchmarks.end(),
    [&name](const Benchmark& benchmark) { return name == benchmark.Name; });
}

struct Arguments
{
  // Returns false with the first unknown argument. After "--", all arguments are names.
  bool Parse(int argc, char* argv[])
  {
    bool areNames = false;
    for (int i = 1; i < argc; ++i)
    {
      const std::string argument = argv[i];
      if (areNames || IsBenchmark(argument))
      {
        this->Names.push_back(argument);
      }
      else if (argument == "--")
      {
        areNames = true;
      }
      else if (argument == "--quick")
      {
        this->Options.Quick = true;
      }
      else if (argument == "--full")
      {
        this->Options.Full = true;
      }
      else if (argument == "--height-map" && i + 1 < argc)
      {
        this->Options.HeightMap = argv[++i];
      }
      else if (argument == "--paraview" && i + 1 < argc)
      {
        this->Options.ParaView = argv[++i];
      }
      else if (argument == "--output" && i + 1 < argc)
      {
        this->Output = argv[++i];
      }
      else
      {
        this->Unknown = argument;
        return false;
      }
    }
    const auto unknown = std::find_if_not(this->Names.begin(), this->Names.end(), IsBenchmark);
    this->Unknown = unknown == this->Names.end() ? "" : *unknown;
    return unknown == this->Names.end();
  }

  BenchmarkOptions Options;
  std::string Output;
  std::vector<std::string> Names;
  std::string Unknown;
};

bool CanRead(const std::string& file)
{
  if (!file.empty() && !std::ifstream(file))
  {
    ShowError("cannot read " + file);
    return false;
  }
  return true;
}

// Checks this before hours of measurements.
bool CanWrite(const std::string& file)
{
  const std::string error = file.empty() ? "" : relevo::AtomicFile::FindError(file);
  if (!error.empty())
  {
    ShowError("cannot write " + file + ": " + error);
  }
  return error.empty();
}

// All benchmarks if none is named.
std::vector<Benchmark> ChooseBenchmarks(const std::vector<std::string>& names)
{
  std::vector<Benchmark> chosen;
  std::copy_if(Benchmarks.begin(), Benchmarks.end(), std::back_inserter(chosen),
    [&names](const Benchmark& benchmark) {
      return names.empty() || std::find(names.begin(), names.end(), benchmark.Name) != names.end();
    });
  return chosen;
}

// Quotes a name for the shell.
std::string Quote(const std::string& text)
{
  std::string quoted = "'";
  for (const char c : text)
  {
    quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  }
  return quoted + "'";
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

void AddFacts(BenchmarkReport& report, const std::vector<Benchmark>& chosen)
{
  if (std::any_of(chosen.begin(), chosen.end(),
        [](const Benchmark& benchmark) { return benchmark.NeedsOpenGL; }))
  {
    report.AddFact("OpenGL renderer", BenchmarkView().GetOpenGLRenderer());
  }
  report.AddFact("VTK", vtkVersion::GetVTKVersion());
  report.AddFact("Machine",
    GetProcessor() + std::to_string(std::thread::hardware_concurrency()) + " logical cores");
}

bool WriteJson(const BenchmarkReport& report, const std::string& output)
{
  std::ostringstream text;
  report.WriteJson(text);
  const std::string error = relevo::AtomicFile::Write(output, text.str());
  if (!error.empty())
  {
    ShowError("cannot write " + output + ": " + error);
  }
  return error.empty();
}
}

std::vector<double> RunInOwnProcess(const std::vector<std::string>& arguments)
{
  std::string command = Quote(ProgramPath) + ' ' + MeasureOption;
  for (const std::string& argument : arguments)
  {
    command += ' ' + Quote(argument);
  }
  std::vector<double> values;
  if (FILE* pipe = popen(command.c_str(), "r"))
  {
    double value;
    while (fscanf(pipe, "%lf", &value) == 1)
    {
      values.push_back(value);
    }
    if (pclose(pipe) != 0)
    {
      values.clear();
    }
  }
  return values;
}

int main(int argc, char* argv[])
{
  ProgramPath = argv[0];
  if (argc > 1 && argv[1] == MeasureOption)
  {
    return Measure({ argv + 2, argv + argc });
  }
  Arguments arguments;
  if (!arguments.Parse(argc, argv))
  {
    return ShowUsage(arguments.Unknown);
  }
  BenchmarkOptions& options = arguments.Options;
  std::error_code error;
  options.ProgramFolder =
    std::filesystem::read_symlink("/proc/self/exe", error).parent_path().string();
  if (!CanRead(options.HeightMap) || !CanWrite(arguments.Output) ||
    !CanRead(options.ParaView.empty() ? "" : options.ParaView + "/bin/paraview-python"))
  {
    return EXIT_FAILURE;
  }

  const std::vector<Benchmark> chosen = ChooseBenchmarks(arguments.Names);
  BenchmarkReport report;
  AddFacts(report, chosen);
  report.WriteFacts(std::cout);
  auto addTable = [&](const BenchmarkTable& table) { report.Add(table, std::cout); };
  for (const Benchmark& benchmark : chosen)
  {
    benchmark.Run(options, addTable);
  }
  return arguments.Output.empty() || WriteJson(report, arguments.Output) ? EXIT_SUCCESS
                                                                         : EXIT_FAILURE;
}
