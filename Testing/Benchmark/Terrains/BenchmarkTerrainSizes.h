// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   large rasters: index, first picture, flight and memory
 */
#ifndef BenchmarkTerrainSizes_h
#define BenchmarkTerrainSizes_h

#include "Benchmarks.h"

/// Measures a large raster and a sparse one that is larger still.
void AddTerrainSizes(const BenchmarkOptions& options, const AddTable& addTable);

/// index FILE -> seconds, and bytes by which the process has grown
std::vector<double> MeasureTerrainIndex(const std::vector<std::string>& arguments);

/// flight FILE BASE MEBIBYTES FRAMES DELAY -> seconds to the first picture and until it is
/// complete, median and 99th percentile of frames in seconds, largest error of the complete picture
/// in pixels, bytes by which the process has grown at most, triangles of the complete picture
std::vector<double> MeasureTerrainFlight(const std::vector<std::string>& arguments);

#endif
