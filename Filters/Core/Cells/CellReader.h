// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   the cells of a grid, one at a time, with their degrees and faces
 *
 * Private to the modules' own sources.
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
/// For one thread.
class RELEVOFILTERSCORE_EXPORT CellReader
{
public:
  explicit CellReader(vtkUnstructuredGrid* grid);
  ~CellReader();

  /// What follows is of this cell. False where the grid's lists of cells are too short or not in
  /// order: then it has no nodes.
  bool Read(vtkIdType cell);
  /// The same without faces, in less time.
  bool ReadNodes(vtkIdType cell);

  vtkIdType GetCell() const { return this->Cell; }
  const CellKind& GetKind() const { return this->Kind; }
  vtkIdType GetNumberOfNodes() const;
  vtkIdType GetNode(vtkIdType node) const;
  /// Of Lagrange's and Bézier's kinds, in each direction; 0 if there is no degree with so many
  /// nodes. A triangle's, tetrahedron's and wedge's first are the same.
  ivec3 GetDegrees() const;
  /// The grid's array has no degrees that VTK can read for this cell.
  bool LacksDegrees() const;
  /// A degree as the grid's array has it; as GetDegrees() if there is no array.
  double GetGivenDegree(int direction) const;

  /// Polygons have one, strips as many as they need; polyhedra none if their list of faces is not
  /// whole.
  /// They may have points that the cell does not list, or that do not exist.
  int GetNumberOfFaces() const { return static_cast<int>(this->Faces.size()); }
  /// The points at a face's corners, counter-clockwise from outside if IsInsideOut() is false.
  const std::vector<vtkIdType>& GetCorners(int face) const { return this->Faces[face]; }
  /// The nodes at these corners, but of polyhedra.
  FaceCorners GetFaceCorners(int face) const;
  /// Whether the cell's faces, as they are numbered, enclose less than nothing.
  bool IsInsideOut() const;

private:
  void ReadFaces();
  vtkDataArray* GetDegreeArray() const;

  vtkUnstructuredGrid* Grid;
  vtkIdType NumberOfTypes;
  vtkIdType Cell = 0;
  CellKind Kind;
  vtkNew<vtkIdList> Nodes;
  vtkNew<vtkIdList> Scratch;
  std::vector<std::vector<vtkIdType>> Faces;
};

/// (degree + 1)^2 and the like.
RELEVOFILTERSCORE_EXPORT vtkIdType GetNumberOfNodes(CellTopology shape, const ivec3& degrees);
}

#endif
