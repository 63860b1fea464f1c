// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   volumes of cells that do not share all points with their neighbours
 */
#ifndef BenchmarkVolumeNeighbors_h
#define BenchmarkVolumeNeighbors_h

#include "Benchmarks.h"

/// Adds a table of frames: cells with points and values of their own, and cells next to smaller
/// ones.
void AddVolumeNeighbors(const BenchmarkOptions& options, const AddTable& addTable);

#endif
