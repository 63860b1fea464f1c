// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Measures terrains that are drawn within a number of pixels of their full resolution.
#include "BenchmarkTerrainFrames.h"
#include "BenchmarkTerrainSizes.h"
#include "BenchmarkTerrainTriangles.h"
#include "BenchmarkTerrainWarp.h"
#include "BenchmarkTerrainWriter.h"
#include "Benchmarks.h"

void RunTerrains(const BenchmarkOptions& options, const AddTable& addTable)
{
  AddTerrainFrames(options, addTable);
  AddTerrainTriangles(options, addTable);
  AddTerrainCameras(options, addTable);
  AddTerrainWarp(options, addTable);
  AddTerrainWriter(options, addTable);
  AddTerrainSizes(options, addTable);
}

std::vector<double> MeasureTerrains(const std::vector<std::string>& arguments)
{
  const std::vector<std::string> rest(arguments.begin() + 1, arguments.end());
  if (arguments.at(0) == "index")
  {
    return MeasureTerrainIndex(rest);
  }
  return arguments[0] == "flight" ? MeasureTerrainFlight(rest) : MeasureTerrainWarp(rest);
}
