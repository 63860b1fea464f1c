// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   pixels of reliefs, compared with rays in double precision
 */
#ifndef BenchmarkReliefAccuracy_h
#define BenchmarkReliefAccuracy_h

#include "Benchmarks.h"

/// Adds the shares of pixels that are correct within half a texel, for all ways.
void AddReliefAccuracy(const BenchmarkOptions& options, const AddTable& addTable);

#endif
