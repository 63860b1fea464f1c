// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   frames and warps a second, one beside the other
 */
#ifndef BenchmarkWarpFrames_h
#define BenchmarkWarpFrames_h

#include "Benchmarks.h"

/// The warped picture as texture of one quad in a window of 400 x 300 pixels, while the camera
/// moves: each frame with its own warp, or warps by a worker.
void AddWarpFrames(const BenchmarkOptions& options, const AddTable& addTable);

#endif
