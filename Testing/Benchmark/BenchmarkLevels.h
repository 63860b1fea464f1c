// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   depth-tags of a coarse mesh that refine it to a wanted number of triangles
 */
#ifndef BenchmarkLevels_h
#define BenchmarkLevels_h

#include <functional>

class vtkFloatArray;
class vtkPolyData;

namespace BenchmarkLevels
{
/// The point array "DepthTag" of the mesh, added where it is not there.
vtkFloatArray* GetTags(vtkPolyData* mesh);

/**
 * Call setTags() with a number in [low, high], which must change the mesh's tags so that levels
 * grow with it, and leave the tags at the number that takes the mesh nearest to the wanted
 * triangles. Returns how many there are then, by the linear recipe with levels up to the highest.
 */
double FindTags(vtkPolyData* mesh, double triangles, double low, double high,
  const std::function<void(double)>& setTags);

/**
 * Random tags by one seed, uniform over a range of levels that begins at 0, and where that is not
 * enough over one that ends at the highest level; the range is FindTags()'s. Returns the same.
 */
double SetRandomTags(vtkPolyData* mesh, double triangles);
}

#endif
