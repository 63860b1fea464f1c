// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   meshes of a mountain
 */
#ifndef BenchmarkTerrainTriangles_h
#define BenchmarkTerrainTriangles_h

#include "Benchmarks.h"

/// Compares meshes within a vertical distance with those of vtkGreedyTerrainDecimation.
void AddTerrainTriangles(const BenchmarkOptions& options, const AddTable& addTable);

/// Measures the error on the screen for random cameras.
void AddTerrainCameras(const BenchmarkOptions& options, const AddTable& addTable);

#endif
