// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   files of rasters that the benchmark generates
 */
#ifndef BenchmarkTerrainFiles_h
#define BenchmarkTerrainFiles_h

#include "Benchmarks.h"
#include "vtkSmartPointer.h"

#include <array>
#include <string>
#include <vector>

class BenchmarkRaster;
class vtkTerrainPyramid;

/// The name of a file in a folder beside the program, or, if that is read-only, in the folder for
/// temporary files. Files stay there for the next run.
std::string GetTerrainFile(const BenchmarkOptions& options, const std::string& name);

/// Write the raster as a pyramid. Returns false on failure.
bool WriteTerrainPyramid(const BenchmarkRaster& raster, const std::string& fileName);

/// Write a fractal of size x size samples of int16, tile by tile, if there is no such file yet.
/// Without overviews if `isPlain`.
bool WriteFractal(const std::string& fileName, int size, bool isPlain = false);

/// The same for a sparse raster, of which only squares of patchSize x patchSize samples are stored.
bool WriteSparseFractal(const std::string& fileName, int size, int patchSize,
  const std::vector<std::array<int, 2>>& patches);

/// A pyramid whose index is complete; nullptr on failure.
vtkSmartPointer<vtkTerrainPyramid> OpenTerrain(const std::string& fileName);

#endif
