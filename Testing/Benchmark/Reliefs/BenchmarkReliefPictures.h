// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   pictures of reliefs, compared with those of the captured scene
 */
#ifndef BenchmarkReliefPictures_h
#define BenchmarkReliefPictures_h

#include "Benchmarks.h"

/// Adds a table of similarity and holes for views around the captures, with the mesh of pixels for
/// comparison.
void AddReliefPictures(const BenchmarkOptions& options, const AddTable& addTable);

#endif
