// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   frames of a mountain, and their triangles
 */
#ifndef BenchmarkTerrainFrames_h
#define BenchmarkTerrainFrames_h

#include "Benchmarks.h"

/// Compares frames of vtkTerrainMapper with those of the full mesh, and its triangles with those of
/// a uniform grid that has the same error on the screen.
void AddTerrainFrames(const BenchmarkOptions& options, const AddTable& addTable);

#endif
