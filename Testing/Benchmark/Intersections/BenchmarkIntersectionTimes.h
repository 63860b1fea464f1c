// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   a large mesh intersected with its moved copy, compared with VTK's filters
 */
#ifndef BenchmarkIntersectionTimes_h
#define BenchmarkIntersectionTimes_h

#include "Benchmarks.h"

void AddIntersectionTimes(const BenchmarkOptions& options, const AddTable& addTable);

#endif
