// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   GridBlocks
 * @brief   isosurfaces of blocks of an unstructured grid
 *
 * Only cells that contain an isovalue are in blocks. They are divided at medians of their centres,
 * along the longest side of their box.
 */
#ifndef GridBlocks_h
#define GridBlocks_h

#include "Blocks/ContourSettings.h"
#include "vtkSmartPointer.h" // for return values
#include "vtkType.h"         // for vtkIdType

#include <string> // for errors
#include <vector> // for members

class vtkPolyData;
class vtkUnsignedCharArray;
class vtkUnstructuredGrid;

namespace relevo
{
class GridBlocks
{
public:
  /// Find the blocks, each with at most `mostCells` cells. Returns false and an error for the user
  /// if the scalars are missing or invalid, or if the grid has faults.
  bool Find(vtkUnstructuredGrid* grid, const ContourSettings& settings, vtkIdType mostCells,
    std::string& error);

  int GetNumberOfBlocks() const { return static_cast<int>(this->Firsts.size()) - 1; }

  /// Return the isosurface of a block. The point array FixedPointsName has a value other than 0 at
  /// points that other blocks share.
  vtkSmartPointer<vtkPolyData> Contour(
    vtkUnstructuredGrid* grid, int block, const ContourSettings& settings) const;

private:
  void FindCells(vtkUnstructuredGrid* grid, vtkDataArray* scalars,
    const std::vector<double>& values, const std::vector<char>& areSolid);
  void Divide(vtkUnstructuredGrid* grid, vtkIdType mostCells);
  void MarkSharedPoints(vtkUnstructuredGrid* grid);

  std::vector<vtkIdType> Cells;
  std::vector<std::size_t> Firsts;             // cell of each block, and the total
  vtkSmartPointer<vtkUnsignedCharArray> Marks; // per point, whether several blocks have it
};
}

#endif
