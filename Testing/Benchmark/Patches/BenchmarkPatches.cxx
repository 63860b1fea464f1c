// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Compares curved cells and hair with VTK's uniform subdivision.
#include "BenchmarkHairs.h"
#include "BenchmarkPatchFrames.h"
#include "BenchmarkPatchPictures.h"
#include "BenchmarkPatchTriangles.h"
#include "Benchmarks.h"

void RunPatches(const BenchmarkOptions& options, const AddTable& addTable)
{
  AddPatchTriangles(options, addTable);
  AddPatchFrames(options, addTable);
  AddPatchPictures(options, addTable);
  AddHairs(options, addTable);
}

std::vector<double> MeasurePatches(const std::vector<std::string>& arguments)
{
  return MeasurePatchFirstPicture({ arguments.begin() + 1, arguments.end() });
}
