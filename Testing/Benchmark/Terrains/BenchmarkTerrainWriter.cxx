// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkTerrainWriter.h"

#include "BenchmarkMeasure.h"
#include "BenchmarkReport.h"
#include "BenchmarkTerrainFiles.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <limits>
#include <system_error>

namespace
{
// Seconds, or NaN after an error.
double TimeCommand(const std::string& command)
{
  const Stopwatch stopwatch;
  const bool isDone = std::system(command.c_str()) == 0;
  return isDone ? stopwatch.GetSeconds() : std::numeric_limits<double>::quiet_NaN();
}
}

void AddTerrainWriter(const BenchmarkOptions& options, const AddTable& addTable)
{
  BenchmarkTable table("terrain-writer",
    "Time to write a pyramid: relevo-pyramid (A) against gdal_translate -of COG (B)",
    { { "compression", "compression", 0 }, { "ratio_a_s", "A, s", 2 }, { "ratio_b_s", "B, s", 2 },
      { "ratio_times", "A / B", 2 }, { "with_index_s", "A with the index, s", 2 },
      { "ratio_a_mb", "A, MB", 1 }, { "ratio_b_mb", "B, MB", 1 } });
  const int size = options.Quick ? 512 : 8192;
  const std::string input = GetTerrainFile(options, "plain-tiles-" + std::to_string(size) + ".tif");
  const std::string program = options.ProgramFolder + "/relevo-pyramid";
  const bool hasInput = WriteFractal(input, size, true);
  const bool hasPrograms =
    std::filesystem::exists(program) && std::system("command -v gdal_translate > /dev/null") == 0;
  for (const std::string compression : { "DEFLATE", "LZW", "ZSTD" })
  {
    if (!hasInput || !hasPrograms)
    {
      break;
    }
    std::cerr << "terrain: writing with " << compression << std::endl;
    const std::string outputs[2] = { GetTerrainFile(options, "a.tif"),
      GetTerrainFile(options, "b.tif") };
    std::string option = compression;
    std::transform(option.begin(), option.end(), option.begin(),
      [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
    const std::string commands[3] = { "'" + program + "' --no-index --compression " + option +
        " '" + input + "' '" + outputs[0] + "' 2> /dev/null",
      "gdal_translate -q -of COG -co COMPRESS=" + compression +
        " -co PREDICTOR=YES -co BLOCKSIZE=256 -co BIGTIFF=YES -co OVERVIEW_RESAMPLING=AVERAGE "
        "-co NUM_THREADS=ALL_CPUS '" +
        input + "' '" + outputs[1] + "'",
      "'" + program + "' --compression " + option + " '" + input + "' '" + outputs[0] +
        "' 2> /dev/null" };
    std::vector<double> times[3];
    double bytes[2] = { 0.0, 0.0 };
    for (int round = 0; round < (options.Quick ? 1 : 3); ++round)
    {
      for (int way = 0; way < 3; ++way)
      {
        std::error_code error;
        const std::string& output = outputs[way % 2];
        times[way].push_back(TimeCommand(commands[way]));
        bytes[way % 2] = static_cast<double>(std::filesystem::file_size(output, error));
        std::filesystem::remove(output, error);
        std::filesystem::remove(output + ".relevo-index", error);
      }
    }
    table.AddRow({ compression, GetMedian(times[0]), GetMedian(times[1]),
      GetMedianRatio(times[0], times[1]), GetMedian(times[2]), 1e-6 * bytes[0], 1e-6 * bytes[1] });
  }
  table.AddNote(hasPrograms
      ? "A fractal, " + std::to_string(size) + " x " + std::to_string(size) +
        " samples of int16, both with all cores, a predictor and overviews of averages. A / B does "
        "not include the index. Asked: 1.2."
      : "Without relevo-pyramid beside the benchmark, or without gdal_translate.");
  addTable(table);
}
