// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   hair as curves, against evenly cut lines
 */
#ifndef BenchmarkHairs_h
#define BenchmarkHairs_h

#include "Benchmarks.h"

/// Memory, frames and segments of equal error.
void AddHairs(const BenchmarkOptions& options, const AddTable& addTable);

#endif
