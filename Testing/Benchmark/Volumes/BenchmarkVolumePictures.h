// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   pictures of volumes, compared with references
 */
#ifndef BenchmarkVolumePictures_h
#define BenchmarkVolumePictures_h

#include "Benchmarks.h"

/// Adds a table of the errors of all ways.
void AddVolumePictures(const BenchmarkOptions& options, const AddTable& addTable);

/// Scene, way and size -> the largest error and the 99.9 % quantile, of 255.
std::vector<double> MeasureVolumePicture(const std::vector<std::string>& arguments);

#endif
