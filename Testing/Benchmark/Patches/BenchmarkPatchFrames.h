// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   first pictures, frames and memory of hexahedra
 */
#ifndef BenchmarkPatchFrames_h
#define BenchmarkPatchFrames_h

#include "Benchmarks.h"

/// Compares cubic hexahedra as patches with vtkDataSetSurfaceFilter and vtkPolyDataMapper.
void AddPatchFrames(const BenchmarkOptions& options, const AddTable& addTable);

/// WAY SIDE -> seconds from the grid to the first picture, bytes of meshes and buffers
std::vector<double> MeasurePatchFirstPicture(const std::vector<std::string>& arguments);

#endif
