// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   pictures of reliefs against those of what they show
 */
#ifndef BenchmarkReliefPictures_h
#define BenchmarkReliefPictures_h

#include "Benchmarks.h"

/// A table of likeness and of holes, from views around the captures, beside the mesh of pixels.
void AddReliefPictures(const BenchmarkOptions& options, const AddTable& addTable);

#endif
