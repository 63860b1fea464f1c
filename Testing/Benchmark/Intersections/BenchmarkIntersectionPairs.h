// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   small meshes with whole coordinates: intersecting triangles, compared with exact
 * arithmetic
 */
#ifndef BenchmarkIntersectionPairs_h
#define BenchmarkIntersectionPairs_h

#include "Benchmarks.h"

void AddIntersectionPairs(const BenchmarkOptions& options, const AddTable& addTable);
/// pairs WAY NUMBER -> the figures of a row
std::vector<double> MeasureIntersectionPairs(const std::vector<std::string>& arguments);

#endif
