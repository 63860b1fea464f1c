// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   Benchmarks
 * @brief   what can be measured; each adds its tables to the report
 */
#ifndef Benchmarks_h
#define Benchmarks_h

#include <functional>
#include <string>

class BenchmarkTable;

struct BenchmarkOptions
{
  bool Quick = false;     // sizes that only show that everything runs
  std::string HeightMap;  // a raster file for the terrain; empty to make one
  std::string WorkFolder; // for files made on the way
};

using AddTable = std::function<void(const BenchmarkTable&)>;

/// Frames of the mapper against the same triangles as a static mesh.
void RunStaticMesh(const BenchmarkOptions& options, const AddTable& addTable);

#endif
