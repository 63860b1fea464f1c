// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   number of triangles for an error of half a pixel
 */
#ifndef BenchmarkPatchTriangles_h
#define BenchmarkPatchTriangles_h

#include "Benchmarks.h"

/// Compares the teapot's triangles in windows of several sizes with vtkDataSetSurfaceFilter at its
/// lowest sufficient level, for the whole teapot and at tenfold zoom.
void AddPatchTriangles(const BenchmarkOptions& options, const AddTable& addTable);

#endif
