// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Random unstructured grids of all types of cells, sound ones and such with a known fault.
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

  // The fault in words for messages; empty for a sound grid.
  const std::string& GetError() const { return this->Error; }
  // Whether all who take the grid have to report the fault: it is none of those that may be sound
  // by chance.
  bool IsCertain() const { return this->IsSure; }
  // Whether the fault is a point or a weight that is not finite, of a cell of this dimension.
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
  std::vector<Cell> Cells; // sound or not, as they were put in
  bool HasDegrees;
  bool HasWeights;
  std::string Error;
  bool IsSure = true;
  bool IsPointError = false;
  int Dimension = -1; // of the cell with the fault, if it is one cell's
};
}

#endif
