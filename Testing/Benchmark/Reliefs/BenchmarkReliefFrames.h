// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   frames and memory of reliefs
 */
#ifndef BenchmarkReliefFrames_h
#define BenchmarkReliefFrames_h

#include "Benchmarks.h"

/// Compares frames of four captures with frames of the captured scene, for all ways.
void AddReliefFrames(const BenchmarkOptions& options, const AddTable& addTable);

/// Compares resident memory with that of a mesh of pixels.
void AddReliefMemory(const BenchmarkOptions& options, const AddTable& addTable);

/// reliefs|pixels SIZE -> bytes by which the process has grown, and valid texels
std::vector<double> MeasureReliefMemory(const std::vector<std::string>& arguments);

#endif
