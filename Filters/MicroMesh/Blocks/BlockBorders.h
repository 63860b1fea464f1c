// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   BlockBorders
 * @brief   makes the micro-meshes of blocks have the same points on common borders
 *
 * All blocks simplify their common border in the same way, if nothing else prevents it. A block
 * that keeps more points is matched by encoding the others again, with these points kept. Blocks
 * match at the end, because kept points are never removed. The block that is first to keep a point
 * sets the direction of its displacements.
 *
 * Points are compared by their coordinates, which are the same to the bit in all blocks.
 */
#ifndef BlockBorders_h
#define BlockBorders_h

#include <array>   // for points
#include <cstddef> // for std::size_t
#include <map>     // for members
#include <vector>  // for members

class vtkDataArray;
class vtkPolyData;

namespace relevo
{
class BlockBorders
{
public:
  /// Marks of points of a volume have two components: whether several blocks have the point, and
  /// whether several of their borders do. Points interpolated between two such points are marked.
  static constexpr unsigned char IsShared = 255;

  /// Set the point array FixedPointsName of the isosurface of a block from the interpolated marks
  /// of the volume, which have the same name. It has no directions yet.
  static void SetFixedPoints(vtkPolyData* surface);

  explicit BlockBorders(std::size_t numberOfBlocks = 0)
    : Removed(numberOfBlocks)
  {
  }

  /// Keep the points of an isosurface that blocks have kept, with their directions.
  void Keep(vtkPolyData* surface) const;

  /// Take the points that the micro-mesh of a block has kept, and those that it has removed.
  void Take(std::size_t block, vtkPolyData* surface, vtkPolyData* micro);

  /// Return the blocks that have removed points that others have kept.
  std::vector<std::size_t> FindUnmatched() const;

private:
  using Point = std::array<double, 3>;

  std::map<Point, std::array<float, 3>> Kept; // directions
  std::vector<std::vector<Point>> Removed;    // per block
};
}

#endif
