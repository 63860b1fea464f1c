// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   reads the cells of a grid, one at a time, with their degrees and faces
 */
#ifndef CellReader_h
#define CellReader_h

#include "Cells/CellKind.h"
#include "RelevoFiltersCoreModule.h" // for export macro
#include "vtkNew.h"

#include <vector>

class vtkDataArray;
class vtkIdList;
class vtkUnstructuredGrid;

namespace relevo
{
/// Not thread-safe.
class RELEVOFILTERSCORE_EXPORT CellReader
{
public:
  explicit CellReader(vtkUnstructuredGrid* grid);
  ~CellReader();

  /// Read a cell, for the functions below. Returns false if the grid's lists of cells are too short
  /// or out of order; the cell then has no nodes.
  bool Read(vtkIdType cell);
  /// Read a cell without its faces, which is faster.
  bool ReadNodes(vtkIdType cell);

  vtkIdType GetCell() const { return this->Cell; }
  /// VTK's type; VTK_EMPTY_CELL if the cell could not be read.
  int GetType() const { return this->Type; }
  const CellKind& GetKind() const { return this->Kind; }
  vtkIdType GetNumberOfNodes() const;
  vtkIdType GetNode(vtkIdType node) const;
  /// The degrees of Lagrange and Bézier cells in each direction. They are 0 if no degree has this
  /// number of nodes. The first degree of triangles, tetrahedra and wedges is repeated.
  ivec3 GetDegrees() const;
  /// Whether the grid has an array of degrees, but VTK cannot read degrees for this cell from it.
  bool LacksDegrees() const;
  /// A degree in the grid's array. Without an array, the degree of GetDegrees().
  double GetGivenDegree(int direction) const;

  /// The number of faces. Polygons have one face, strips one or more, and polyhedra none if their
  /// list of faces is truncated. Faces of polyhedra may have points that the cell does not list or
  /// that do not exist.
  int GetNumberOfFaces() const { return static_cast<int>(this->Faces.size()); }
  /// The points at the corners of a face, counter-clockwise from outside if IsInsideOut() is false.
  const std::vector<vtkIdType>& GetCorners(int face) const { return this->Faces[face]; }
  /// The nodes at these corners, except for polyhedra.
  CornerNodes GetCornerNodes(int face) const;
  /// Whether the faces, with their point order, enclose a negative volume.
  bool IsInsideOut() const;

private:
  void ReadFaces();
  vtkDataArray* GetDegreeArray() const;

  vtkUnstructuredGrid* Grid;
  vtkIdType NumberOfTypes;
  vtkIdType Cell = 0;
  int Type = 0;
  CellKind Kind;
  vtkNew<vtkIdList> Nodes;
  vtkNew<vtkIdList> Scratch;
  std::vector<std::vector<vtkIdType>> Faces;
};

/// The number of nodes of a cell with these degrees, for example (degree + 1)^2.
RELEVOFILTERSCORE_EXPORT vtkIdType GetNumberOfNodes(CellTopology shape, const ivec3& degrees);
}

#endif
