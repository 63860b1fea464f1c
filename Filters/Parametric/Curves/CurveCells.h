// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   CurveCells
 * @brief   access to the cells of a data set that are curves, with validation
 *
 * Private to the module.
 */
#ifndef CurveCells_h
#define CurveCells_h

#include "vtkType.h"

#include <string> // for messages

class vtkCellArray;
class vtkDataArray;
class vtkIdList;
class vtkPointSet;
class vtkUnsignedCharArray;
class vtkUnstructuredGrid;

namespace relevo
{
class CurveCells
{
public:
  /// `input` is a vtkUnstructuredGrid or a vtkPolyData. It must outlive this object.
  explicit CurveCells(vtkPointSet* input);

  /// Returns the number of cells of all dimensions.
  vtkIdType GetNumberOfCells() const { return this->NumberOfCells; }

  enum Kinds
  {
    NO_CURVE, // also cells that are blanked or belong to another piece
    LINES,    // a curve for each segment
    LAGRANGE,
    BEZIER,
    UNKNOWN
  };
  Kinds GetKind(vtkIdType cell) const;

  /// Returns the points in the order of the curve, or none if the input is corrupt. Can be called
  /// from several threads with separate lists.
  void GetPoints(vtkIdType cell, Kinds kind, vtkIdList* points) const;

  /// Returns the weight of a point, 1 if cells of this kind have no weights.
  double GetWeight(Kinds kind, vtkIdType point) const;

  /// Returns the error of a cell with these points, as a continuation of "Cell n ", or "".
  std::string FindError(vtkIdType cell, Kinds kind, vtkIdList* points) const;

private:
  int GetType(vtkIdType cell) const;
  std::string FindNumberError(vtkIdType cell, Kinds kind, vtkIdType number) const;
  std::string FindPointError(Kinds kind, vtkIdType point) const;

  vtkPointSet* Input;
  vtkUnstructuredGrid* Grid; // nullptr for a vtkPolyData
  vtkCellArray* Cells = nullptr;
  vtkIdType FirstCell = 0; // id of the first cell of Cells in the input
  vtkIdType NumberOfCells;
  vtkIdType NumberOfTypes = 0; // for a vtkUnstructuredGrid
  vtkUnsignedCharArray* Ghosts;
  vtkDataArray* Degrees = nullptr;
  vtkDataArray* Weights = nullptr;
};
}

#endif
