// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   hair as curves, compared with uniformly split lines
 */
#ifndef BenchmarkHairs_h
#define BenchmarkHairs_h

#include "Benchmarks.h"

/// Adds memory, frames and segments for equal errors.
void AddHairs(const BenchmarkOptions& options, const AddTable& addTable);

#endif
