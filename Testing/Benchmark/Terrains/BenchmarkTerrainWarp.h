// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   a raster of heights, from the file to the picture
 */
#ifndef BenchmarkTerrainWarp_h
#define BenchmarkTerrainWarp_h

#include "Benchmarks.h"

/// Compares vtkTerrainMapper with reader, vtkImageDataGeometryFilter, vtkWarpScalar and normals.
void AddTerrainWarp(const BenchmarkOptions& options, const AddTable& addTable);

/// vtk|terrain FILE PICTURE -> seconds to the first picture, seconds of a frame, bytes by which the
/// process has grown at most, triangles. Writes the RGB bytes of the picture to a file.
std::vector<double> MeasureTerrainWarp(const std::vector<std::string>& arguments);

#endif
