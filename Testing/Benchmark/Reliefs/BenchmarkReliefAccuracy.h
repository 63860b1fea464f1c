// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   pixels of reliefs against rays in double precision
 */
#ifndef BenchmarkReliefAccuracy_h
#define BenchmarkReliefAccuracy_h

#include "Benchmarks.h"

/// Shares of pixels that are right within half a texel, for all ways.
void AddReliefAccuracy(const BenchmarkOptions& options, const AddTable& addTable);

#endif
