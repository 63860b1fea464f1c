// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   CellFaces
 * @brief   the faces of 3D cells, by the points at their corners
 *
 * Private to the module's own sources.
 */
#ifndef CellFaces_h
#define CellFaces_h

#include "RelevoFiltersVolumeModule.h" // for export macro
#include "vtkType.h"                   // for vtkIdType

#include <array>
#include <cstddef>
#include <string> // for faults
#include <unordered_map>
#include <vector>

class vtkCell;
class vtkDataSet;

namespace relevo
{
class RELEVOFILTERSVOLUME_EXPORT CellFaces
{
public:
  /// Merged points, as ComputeMergedPoints() says which points coincide: these become one.
  explicit CellFaces(std::vector<vtkIdType> mergedPoints = {});

  /// Before the first cell.
  void Reserve(size_t numberOfCells);

  /// A tetrahedron, hexahedron, voxel, wedge or pyramid, linear or quadratic, by the ids of its
  /// points; false for other types.
  bool Add(int type, const vtkIdType* points);

  /// Any 3D cell. Of curved faces the corners count.
  void Add(vtkCell* cell);

  size_t GetNumberOfCells() const { return this->Firsts.size() - 1; }

  /// Cell after cell, and in turn around each face, counterclockwise where VTK's cells are seen
  /// from outside. Of triangles the last corner is -1. Of polygons there are the lowest ids.
  std::vector<std::array<int, 4>> Faces;
  /// Of faces that are polygons: corners by which to find their planes and centres.
  std::unordered_map<size_t, std::array<int, 4>> Polygons;
  /// The first of each cell, and one more: how many there are.
  std::vector<size_t> Firsts = { 0 };

private:
  int Merge(vtkIdType point);

  std::vector<vtkIdType> MergedPoints;
};

/// All 3D cells of a mesh without faults, and which they are. Points that coincide are one.
/// `faults` are as CheckCells() describes them.
RELEVOFILTERSVOLUME_EXPORT CellFaces ReadCellFaces(
  vtkDataSet* mesh, std::vector<vtkIdType>& cells, std::vector<std::string>& errors);
}

#endif
