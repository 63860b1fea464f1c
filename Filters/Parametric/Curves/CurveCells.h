// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   CurveCells
 * @brief   which cells of a data set are curves, and what is wrong with those that are not
 *
 * Private to the module's own sources.
 */
#ifndef CurveCells_h
#define CurveCells_h

#include "vtkType.h"

#include <string> // for faults

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
  /// A vtkUnstructuredGrid or a vtkPolyData, which must live as long.
  explicit CurveCells(vtkPointSet* input);

  /// Of all dimensions.
  vtkIdType GetNumberOfCells() const { return this->NumberOfCells; }

  enum Kinds
  {
    NO_CURVE, // or another piece's, or blanked
    LINES,    // a curve for each two points that follow one another
    LAGRANGE,
    BEZIER,
    UNKNOWN
  };
  Kinds GetKind(vtkIdType cell) const;

  /// Its points, in the order of the curve; none where the input's lists are broken. May be called
  /// from several threads, each with its own list.
  void GetPoints(vtkIdType cell, Kinds kind, vtkIdList* points) const;

  /// That of a point; 1 where cells of the kind have none.
  double GetWeight(Kinds kind, vtkIdType point) const;

  /// What is wrong with the cell, whose points are these: words that follow "Cell n "; empty for
  /// nothing.
  std::string FindError(vtkIdType cell, Kinds kind, vtkIdList* points) const;

private:
  int GetType(vtkIdType cell) const;
  std::string FindNumberError(vtkIdType cell, Kinds kind, vtkIdType number) const;
  std::string FindPointError(Kinds kind, vtkIdType point) const;

  vtkPointSet* Input;
  vtkUnstructuredGrid* Grid; // nullptr of a vtkPolyData
  vtkCellArray* Cells = nullptr;
  vtkIdType FirstCell = 0; // among the input's, of Cells
  vtkIdType NumberOfCells;
  vtkIdType NumberOfTypes = 0; // of a vtkUnstructuredGrid
  vtkUnsignedCharArray* Ghosts;
  vtkDataArray* Degrees = nullptr;
  vtkDataArray* Weights = nullptr;
};
}

#endif
