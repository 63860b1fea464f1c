// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   warps a second by the policies of vtkReliefWarper
 */
#ifndef BenchmarkWarps_h
#define BenchmarkWarps_h

#include "Benchmarks.h"

/// Samples with under 1, about 5 and about 46 % of texels without surface, of 256 and 1024 texels a
/// side.
void AddWarps(const BenchmarkOptions& options, const AddTable& addTable);

#endif
