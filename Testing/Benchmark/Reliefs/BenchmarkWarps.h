// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   warps per second with the policies of vtkReliefWarper
 */
#ifndef BenchmarkWarps_h
#define BenchmarkWarps_h

#include "Benchmarks.h"

/// Samples in which under 1, about 5 and about 46 % of the texels have no surface, with 256 and
/// 1024 texels per side.
void AddWarps(const BenchmarkOptions& options, const AddTable& addTable);

#endif
