// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Random unstructured grids with all types of cells, valid or with a known error.
#ifndef RelevoRandomGrid_h
#define RelevoRandomGrid_h

#include "RelevoFuzz.h"

#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

#include <array>
#include <string>
#include <vector>

namespace RelevoFuzz
{
class RandomGrid
{
public:
  explicit RandomGrid(Dice& dice);

  vtkUnstructuredGrid* Get() { return this->Grid; }

  // The error as text for messages; empty for a valid grid.
  const std::string& GetError() const { return this->Error; }
  // Whether every class must report the error. Some errors may accidentally give a valid grid.
  bool IsCertain() const { return this->IsSure; }
  // Whether the error is a point or a weight that is not finite, in a cell of this dimension.
  bool IsOfPoints() const { return this->IsPointError; }
  int GetDimension() const { return this->Dimension; }
  bool HasDimension(int dimension) const;

private:
  struct Cell
  {
    int Type;
    int Dimension;
    std::vector<vtkIdType> Points;
    std::array<double, 3> Degrees;
  };
  Cell MakeCell();
  std::vector<vtkIdType> ChoosePoints(int number);
  void AddPolyhedron();
  void Insert(const Cell& cell);
  void SpoilCell(Cell& cell);
  void SpoilGrid();
  void SpoilPoint(bool isWeight);
  void SpoilLists();
  void SpoilFaces();
  void AddArrays();
  void Fence();

  Dice& D;
  vtkSmartPointer<vtkUnstructuredGrid> Grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> Points;
  vtkNew<vtkDoubleArray> Degrees;
  vtkNew<vtkDoubleArray> Weights;
  std::vector<Cell> Cells; // as they were added, valid or not
  bool HasDegrees;
  bool HasWeights;
  std::string Error;
  bool IsSure = true;
  bool IsPointError = false;
  int Dimension = -1; // of the invalid cell, if the error belongs to a single cell
};
}

#endif
