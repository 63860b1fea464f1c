// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   frames and warps per second
 */
#ifndef BenchmarkWarpFrames_h
#define BenchmarkWarpFrames_h

#include "Benchmarks.h"

/// The warped picture is the texture of a quad in a window of 400 x 300 pixels while the camera
/// moves, either with one warp per frame or with warps by a worker.
void AddWarpFrames(const BenchmarkOptions& options, const AddTable& addTable);

#endif
