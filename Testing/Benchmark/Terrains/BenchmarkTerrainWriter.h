// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   time to write a pyramid
 */
#ifndef BenchmarkTerrainWriter_h
#define BenchmarkTerrainWriter_h

#include "Benchmarks.h"

/// Compares relevo-pyramid with gdal_translate.
void AddTerrainWriter(const BenchmarkOptions& options, const AddTable& addTable);

#endif
