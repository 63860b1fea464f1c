// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   pictures of a field on curved cells
 */
#ifndef BenchmarkPatchPictures_h
#define BenchmarkPatchPictures_h

#include "Benchmarks.h"

/// Compares colours of pixels with vtkCell's interpolation where their rays hit the cells.
void AddPatchPictures(const BenchmarkOptions& options, const AddTable& addTable);

#endif
