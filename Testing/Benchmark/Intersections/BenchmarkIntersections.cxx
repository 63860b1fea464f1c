// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Compares surface intersection with exact integer arithmetic and VTK's filters, and measures a
// moving scene.
#include "BenchmarkContacts.h"
#include "BenchmarkIntersectionPairs.h"
#include "BenchmarkIntersectionTimes.h"
#include "Benchmarks.h"

void RunIntersections(const BenchmarkOptions& options, const AddTable& addTable)
{
  AddIntersectionPairs(options, addTable);
  AddIntersectionTimes(options, addTable);
  AddContacts(options, addTable);
}

std::vector<double> MeasureIntersections(const std::vector<std::string>& arguments)
{
  return MeasureIntersectionPairs(arguments);
}
