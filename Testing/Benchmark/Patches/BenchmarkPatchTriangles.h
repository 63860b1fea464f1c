// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   how many triangles half a pixel takes
 */
#ifndef BenchmarkPatchTriangles_h
#define BenchmarkPatchTriangles_h

#include "Benchmarks.h"

/// The teapot's, in windows of several sizes, against those of vtkDataSetSurfaceFilter's least
/// sufficient level; of all of it and at tenfold zoom.
void AddPatchTriangles(const BenchmarkOptions& options, const AddTable& addTable);

#endif
