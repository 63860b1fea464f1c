// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   depth-tags that refine a coarse mesh to a given number of triangles
 */
#ifndef BenchmarkLevels_h
#define BenchmarkLevels_h

#include <functional>

class vtkFloatArray;
class vtkPolyData;

namespace BenchmarkLevels
{
/// The point array "DepthTag" of the mesh, which is added if it is missing.
vtkFloatArray* GetTags(vtkPolyData* mesh);

/**
 * Calls setTags() with numbers in [low, high], which must change the mesh's tags so that levels
 * increase with the number, and keeps the tags whose triangles are closest to `triangles`. Returns
 * their number, for a linear recipe with the highest MaximumLevel.
 */
double FindTags(vtkPolyData* mesh, double triangles, double low, double high,
  const std::function<void(double)>& setTags);

/**
 * Random tags with a fixed seed, uniform over a range of levels that begins at 0. If this is not
 * enough, the range ends at the highest level. FindTags() finds the range. Returns the number of
 * triangles.
 */
double SetRandomTags(vtkPolyData* mesh, double triangles);
}

#endif
