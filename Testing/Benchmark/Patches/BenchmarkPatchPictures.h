// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   pictures of a field of curved cells
 */
#ifndef BenchmarkPatchPictures_h
#define BenchmarkPatchPictures_h

#include "Benchmarks.h"

/// Colours of pixels against vtkCell's own interpolation where their rays meet the cells.
void AddPatchPictures(const BenchmarkOptions& options, const AddTable& addTable);

#endif
