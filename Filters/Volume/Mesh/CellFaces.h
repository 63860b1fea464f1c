// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   CellFaces
 * @brief   the faces of 3D cells, described by their corner points
 *
 * Private to the module.
 */
#ifndef CellFaces_h
#define CellFaces_h

#include "RelevoFiltersVolumeModule.h" // for export macro
#include "vtkType.h"                   // for vtkIdType

#include <array>
#include <cstddef>
#include <string> // for messages
#include <unordered_map>
#include <vector>

class vtkCell;
class vtkDataSet;

namespace relevo
{
class RELEVOFILTERSVOLUME_EXPORT CellFaces
{
public:
  /// `mergedPoints` is the result of ComputeMergedPoints(). Coincident points get the same id.
  explicit CellFaces(std::vector<vtkIdType> mergedPoints = {});

  /// Reserves memory. Call this before adding cells.
  void Reserve(size_t numberOfCells);

  /// Adds a linear or quadratic tetrahedron, hexahedron, voxel, wedge or pyramid. Returns false for
  /// other types.
  bool Add(int type, const vtkIdType* points);

  /// Adds any 3D cell. Curved faces are represented by their corners.
  void Add(vtkCell* cell);

  size_t GetNumberOfCells() const { return this->Firsts.size() - 1; }

  /// The faces of all cells. Corners are in cyclic order, counterclockwise from outside for valid
  /// VTK cells. The last corner of a triangle is -1. Polygons have their lowest ids.
  std::vector<std::array<int, 4>> Faces;
  /// For faces that are polygons, the corners that determine plane and centre.
  std::unordered_map<size_t, std::array<int, 4>> Polygons;
  /// The index of the first face of each cell, and the number of faces at the end.
  std::vector<size_t> Firsts = { 0 };

private:
  int Merge(vtkIdType point);

  std::vector<vtkIdType> MergedPoints;
};

/// Reads all valid 3D cells of a mesh and returns their ids in `cells`. Coincident points are
/// merged. `errors` has the messages of CheckCells().
RELEVOFILTERSVOLUME_EXPORT CellFaces ReadCellFaces(
  vtkDataSet* mesh, std::vector<vtkIdType>& cells, std::vector<std::string>& errors);
}

#endif
