// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   the memory of the process for a volume
 */
#ifndef BenchmarkVolumeTasks_h
#define BenchmarkVolumeTasks_h

#include <string>
#include <vector>

/// Scene and "keep" or "free" -> bytes of the data set, and resident bytes beyond it at the peak of
/// the first frame and after it. OpenGL is already in use.
std::vector<double> MeasureVolumeMemory(const std::vector<std::string>& arguments);

#endif
