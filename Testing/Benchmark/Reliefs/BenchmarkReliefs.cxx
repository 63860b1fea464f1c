// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Compares reliefs with the captured meshes, and measures warps.
#include "BenchmarkReliefAccuracy.h"
#include "BenchmarkReliefFrames.h"
#include "BenchmarkReliefPictures.h"
#include "BenchmarkWarpFrames.h"
#include "BenchmarkWarps.h"
#include "Benchmarks.h"

void RunReliefs(const BenchmarkOptions& options, const AddTable& addTable)
{
  AddReliefFrames(options, addTable);
  AddReliefMemory(options, addTable);
  AddReliefPictures(options, addTable);
  AddReliefAccuracy(options, addTable);
  AddWarps(options, addTable);
  AddWarpFrames(options, addTable);
}

std::vector<double> MeasureReliefs(const std::vector<std::string>& arguments)
{
  return MeasureReliefMemory({ arguments.begin() + 1, arguments.end() });
}
